// Made-up variants of a solver, for tests of how two are compared.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/variants.hpp"

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

inline inference::Variant variant(const std::vector<double>& errors_cm, const Change& change = {}) {
  std::vector<results::SolveRecord> solves;
  for (const double error : errors_cm) {
    solves.push_back(solve_of(static_cast<int>(solves.size()) + 1, error));
    if (change) change(solves.back());
  }
  const results::Series series{.key = "key", .label = "mine", .algorithm = "bat", .options = R"({"alpha": "0.9"})"};
  const results::StudyEntry entry{
      .name = "study",
      .definition = fmt::format(R"({{"points": 1, "runs": {}, "stop": {{"iterations": 200}}}})", errors_cm.size()),
      .series = {series}};
  inference::StudyResults study = inference::make_study(entry, std::move(solves));
  const std::string timing = inference::timing_note(study);
  return {.series = series,
          .study = std::move(study),
          .sessions = {{.id = 1, .environment = {{"cpu", "one"}, {"commit", "abc"}}}},
          .timing = timing};
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
  inference::Variant result = variant({1});
  const results::StudyEntry entry{.name = "study", .definition = shape.definition, .series = {result.series}};
  result.study = inference::make_study(entry, records(shape, error_cm, change));
  return result;
}

// Every run has a target of its own.
inline void draw_target(results::SolveRecord& solve) { solve.target_position_m[0] = 0.01 * solve.run; }

inline inference::VariantComparison compared(const inference::Variant& a, const inference::Variant& b,
                                             const std::vector<std::string>& metrics = {},
                                             const inference::MarginQuestion& question = {}) {
  return inference::compare_variants({{a, b}}, metrics, question).front();
}

// The error alone.
inline inference::MetricComparison error_of(const inference::Variant& a, const inference::Variant& b,
                                            const inference::MarginQuestion& question = {}) {
  return compared(a, b, {"position_error_cm"}, question).metrics.front();
}

inline const inference::MetricComparison& metric_of(const inference::VariantComparison& comparison,
                                                    std::string_view name) {
  return *std::ranges::find(comparison.metrics, name, &inference::MetricComparison::metric);
}

// Twenty values about `centre`, evenly within `spread` on either side.
inline std::vector<double> about(double centre, double spread) {
  std::vector<double> values;
  for (int i = 0; i < 20; ++i) values.push_back(centre + spread * ((i * 7 % 20) - 9.5) / 9.5);
  return values;
}

}  // namespace ikbench::variant_samples
