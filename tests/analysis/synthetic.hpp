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
inline std::vector<results::SolveRecord> solves(const Shape& shape) {
  const std::vector<double> error_cm{0.0019, 1.68, 0.365, 0.438, 0.232, 0.4075};
  const std::vector<double> variation_deg{87, 301, 304, 275, 277, 90};
  const std::vector<double> seconds{0.0024, 0.0028, 0.0041, 0.0021, 0.0046, 0.0128};
  Noise noise;
  std::vector<results::SolveRecord> records;
  for (std::size_t s = 0; s < shape.solvers.size(); ++s) {
    for (int run = 1; run <= shape.runs; ++run) {
      for (int point = 1; point <= shape.points; ++point) {
        const double t = 4 * std::numbers::pi * (point - 1) / 20;
        results::SolveRecord r;
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

// The Dobot Magician on Table 8's circle, as the store has the study.
inline const char* const dobot_definition =
    R"({"name": "slim2023-dobot", "published": "slim2023", "robot": "dobot_magician", "runs": 1, "points": 20,
        "path": {"kind": "circle", "centre_cm": [16, 16, 0], "radius_cm": 7, "points": 20},
        "arm": {"links": [
          {"joint": "turns", "offset_deg": 0, "d_m": 0.058, "a_m": 0, "alpha_deg": 0, "limits_deg": [-90, 90]},
          {"joint": "coupled", "offset_deg": 0, "d_m": 0.135, "a_m": 0, "alpha_deg": 0, "limits_deg": [0, 85]},
          {"joint": "coupled", "offset_deg": 0, "d_m": 0, "a_m": 0.147, "alpha_deg": 0, "limits_deg": [-10, 95]}],
          "base": {"position_m": [0, 0, 0], "rpy_deg": [0, 0, 0]},
          "tool": {"position_m": [0.061, 0, 0], "rpy_deg": [0, 0, 0]}}})";

// One run on that circle. The angles are those that reach the points: in the arm's plane the two links are a triangle.
inline std::vector<results::SolveRecord> dobot_solves(int points = 20) {
  Noise noise;
  std::vector<results::SolveRecord> records;
  for (int point = 1; point <= points; ++point) {
    const double t = std::numbers::pi / 10 * (point - 1);
    const double x = 0.16 + 0.07 * std::cos(t), y = 0.16 + 0.07 * std::sin(t);
    const double level = std::hypot(x, y) - 0.061, rise = -0.058, far = std::hypot(level, rise);
    const double lean = std::acos((0.135 * 0.135 + far * far - 0.147 * 0.147) / (2 * 0.135 * far));
    const double theta2 = std::atan2(level, rise) - lean;
    results::SolveRecord r;
    r.study = "slim2023-dobot";
    r.robot = "dobot_magician";
    r.solver = "IK-BA";
    r.series = "dobot-series";
    r.point = point;
    r.target_position_m = r.reached_position_m = {x, y, 0};
    r.target_rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    r.start_rad = {0, 0, 0};
    r.answer_rad = {std::atan2(y, x), theta2,
                    std::atan2(0.135 * std::cos(theta2) - rise, level - 0.135 * std::sin(theta2))};
    r.position_error_cm = 4e-14 * noise.next();
    r.seconds = r.cpu_seconds = 0.004;
    r.iterations = 1000;
    r.session = 1;
    for (int i = 1; i <= 1000; ++i) {
      r.trace_cm.push_back(r.position_error_cm + std::exp(-0.0305 * i) * (10 + noise.next()));
    }
    records.push_back(std::move(r));
  }
  return records;
}

}  // namespace ikbench::synthetic
