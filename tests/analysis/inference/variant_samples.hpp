// Made-up variants of a solver, for tests of how two are compared.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/inference/variant_comparison.hpp"

namespace ikbench::variant_samples {

// One solve a run, clean, of one machine; every run has the same target.
inline results::SolveRecord solve_of(int run, double error_cm) {
  results::SolveRecord solve;
  solve.solver = "mine";
  solve.robot = "arm";
  solve.run = run;
  solve.target_position_m = {0.6, 0.2, 0.1};
  solve.target_rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  solve.start_rad = {0, 0};
  solve.position_error_cm = error_cm;
  solve.variation_deg = 10;
  solve.evaluations = 100;
  solve.seconds = solve.cpu_seconds = 0.001 * run;
  solve.session = 1;
  return solve;
}

using Change = std::function<void(results::SolveRecord&)>;

// A label whose solves are these, in a study with that definition (JSON).
inline inference::Variant variant_of(std::vector<results::SolveRecord> solves, const std::string& definition) {
  const results::Series series{.key = "key", .label = "mine", .algorithm = "bat", .options = R"({"alpha": "0.9"})"};
  return {.study = {.name = "study", .definition = definition, .series = {series}},
          .series = series,
          .sessions = {{.id = 1, .environment = {{"cpu", "one"}, {"commit", "abc"}}}},
          .each_solve = [solves = std::move(solves)](const std::function<void(results::SolveRecord)>& take) {
            for (const results::SolveRecord& solve : solves) take(solve);
          }};
}

inline inference::Variant variant(const std::vector<double>& errors_cm, const Change& change = {}) {
  std::vector<results::SolveRecord> solves;
  for (const double error : errors_cm) {
    solves.push_back(solve_of(static_cast<int>(solves.size()) + 1, error));
    if (change) change(solves.back());
  }
  return variant_of(
      std::move(solves),
      fmt::format(
          R"({{"points": 1, "runs": {}, "path": {{"kind": "helix"}}, "start": "previous", "stop": {{"iterations": 200}}}})",
          errors_cm.size()));
}

// Many points a run: their targets are the path's, and errors what `error_cm` says of run and point.
struct Solved {
  int runs = 1;
  int points = 1;
  std::string definition = "{}";  // of the study, JSON
};

using ErrorOf = std::function<double(int run, int point)>;
inline std::vector<results::SolveRecord> records(const Solved& shape, const ErrorOf& error_cm,
                                                 const Change& change = {}) {
  std::vector<results::SolveRecord> solves;
  for (int run = 1; run <= shape.runs; ++run) {
    for (int point = 1; point <= shape.points; ++point) {
      solves.push_back(solve_of(run, error_cm(run, point)));
      solves.back().point = point;
      solves.back().target_position_m[2] = 0.1 * point;
      if (change) change(solves.back());
    }
  }
  return solves;
}

inline inference::Variant variant(const Solved& shape, const ErrorOf& error_cm, const Change& change = {}) {
  return variant_of(records(shape, error_cm, change), shape.definition);
}

// A study whose every run has a target of its own, and what gives each solve its own.
inline const char* const drawn_targets =
    R"({"points": 1, "runs": 20, "path": {"kind": "random"}, "start": "initial", "stop": {"iterations": 200}})";
inline void draw_target(results::SolveRecord& solve) { solve.target_position_m[0] = 0.01 * solve.run; }

inline inference::VariantComparison compared(const inference::Variant& a, const inference::Variant& b,
                                             const std::vector<std::string>& metrics = {},
                                             const results::AnalysisPlan& plan = {}) {
  const std::vector<inference::VariantStudy> studies{inference::study_of_both(a, b, plan)};
  return inference::compare_variants(studies, metrics).front();
}

// The error alone.
inline inference::MetricComparison error_of(const inference::Variant& a, const inference::Variant& b,
                                            const results::AnalysisPlan& plan = {}) {
  return compared(a, b, {"position_error_cm"}, plan).metrics.front();
}

// Twenty values about `centre`, evenly within `spread` on either side.
inline std::vector<double> about(double centre, double spread) {
  std::vector<double> values;
  for (int i = 0; i < 20; ++i) values.push_back(centre + spread * ((i * 7 % 20) - 9.5) / 9.5);
  return values;
}

}  // namespace ikbench::variant_samples
