// Made-up solves that look like the paper's study, for tests of tables, figures and reports.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "results/record.hpp"

namespace ikbench::synthetic {

// Noise in [0, 1) from a small linear congruential generator (Numerical Recipes' constants).
class Noise {
 public:
  double next() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<double>(state_) / 4294967296.0;
  }

 private:
  std::uint32_t state_ = 12345;
};

struct Shape {
  std::vector<std::string> solvers{"IK-BA", "BA", "DE", "PSO", "K-ABC", "MO-PSO"};
  int runs = 20;
  int points = 20;
};

// Errors, variations and times near those of the paper's Table 3, in the order of the solvers; times in milliseconds.
inline std::vector<SolveRecord> solves(const Shape& shape) {
  const std::vector<double> error_cm{0.0019, 1.68, 0.365, 0.438, 0.232, 0.4075};
  const std::vector<double> variation_deg{87, 301, 304, 275, 277, 90};
  const std::vector<double> seconds{0.0024, 0.0028, 0.0041, 0.0021, 0.0046, 0.0128};
  Noise noise;
  std::vector<SolveRecord> records;
  for (std::size_t s = 0; s < shape.solvers.size(); ++s) {
    for (int run = 1; run <= shape.runs; ++run) {
      for (int point = 1; point <= shape.points; ++point) {
        const double t = 4 * std::numbers::pi * (point - 1) / 20;
        SolveRecord r;
        r.study = "synthetic";
        r.robot = "iiwa";
        r.solver = shape.solvers[s];
        r.series = "series-" + std::to_string(s);
        r.run = run;
        r.point = point;
        r.target_position_m = {0.6 + 0.2 * std::sin(t), 0.2 * std::cos(t), 0.1 + 0.5 * (point - 1) / 20};
        r.target_rotation = {-1, 0, 0, 0, 1, 0, 0, 0, -1};
        for (int joint = 0; joint < 7; ++joint) {
          r.start_rad.push_back(0);
          r.answer_rad.push_back(std::sin(t + joint) * (1 + 0.3 * joint) + 0.1 * noise.next());
        }
        r.position_error_cm = error_cm[s % 6] * std::exp(2 * noise.next() - 1.2);
        r.claimed_error_cm = r.position_error_cm;
        r.variation_deg = variation_deg[s % 6] * (0.5 + noise.next());
        r.evaluations = 10000;
        r.iterations = 200;
        r.seconds = seconds[s % 6] * (0.9 + 0.2 * noise.next());
        r.cpu_seconds = r.seconds;
        r.session = 1;
        records.push_back(std::move(r));
      }
    }
  }
  return records;
}

}  // namespace ikbench::synthetic
