// Hand-made studies.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/compare/compare.hpp"
#include "analysis/compare/describe.hpp"
#include "analysis/compare/gate.hpp"
#include "analysis/compare/judge.hpp"
#include "analysis/compare/observe.hpp"
#include "analysis/compare/study.hpp"
#include "analysis/compare/tests_of_two.hpp"
#include "numerics/units.hpp"
#include "tests/common.hpp"
#include "tests/stored_study.hpp"

using namespace ikbench::compare;

namespace ikbench::compare {

using results::CountedBy;
using results::SolveRecord;
using results::Status;
using results::Timing;

struct Asked {
  std::string start = "previous", targets = "fixed";
  int runs = 5, points = 4;
  double tolerance_cm = 0;
  std::string rest = {};  // further members of the definition
};

inline std::string definition(const Asked& asked) {
  return fmt::format(
      R"({{"start": "{}", "search": "all_joints", "runs": {}, "points": {}, "path": {{"kind": "helix", "targets": "{}"}},
          "stop": {{"tolerance_cm": {}, "evaluations": 1000}}{}}})",
      asked.start, asked.runs, asked.points, asked.targets, asked.tolerance_cm, asked.rest);
}

inline SolveRecord solve_of(const Asked& asked, const std::string& solver, int run, int point) {
  const double target = asked.targets == "drawn" ? 100 * run + point : point;
  return {.label = solver,
          .run = run,
          .point = point,
          .target_position_m = {target, 0, 0},
          .answer_rad = {target, 1.0 * run, static_cast<double>(solver.front())},
          .position_error_cm = 0.5,
          .variation_deg = 30,
          .evaluations = 100,
          .stop_reason = results::StopReason::finished,
          .seconds = 0.001,
          .cpu_seconds = 0.001,
          .session = 1};
}

// Changes a solve after its defaults are set.
using Change = std::function<void(SolveRecord&)>;

inline std::vector<SolveRecord> solves_of(const Asked& asked, const std::vector<std::string>& solvers,
                                          const Change& change) {
  std::vector<SolveRecord> solves;
  for (const std::string& solver : solvers) {
    for (int run = 1; run <= asked.runs; ++run) {
      for (int point = 1; point <= asked.points; ++point) {
        solves.push_back(solve_of(asked, solver, run, point));
        change(solves.back());
      }
    }
  }
  return solves;
}

inline results::StoredStudy entry_of(const Asked& asked, const std::vector<std::string>& solvers) {
  results::StoredStudy entry{.name = "hand-made", .definition = definition(asked), .series = {}};
  for (const std::string& solver : solvers)
    entry.series.push_back({.key = solver + "@1", .label = solver, .algorithm = solver, .options = "{}"});
  return entry;
}

inline StudyResults study(const Asked& asked, const Change& change,
                          const std::vector<std::string>& solvers = {"A", "B"},
                          const std::vector<results::Session>& sessions = {
                              {.id = 1, .environment = {{"cpu", "one"}}}}) {
  return stored_study(entry_of(asked, solvers), solves_of(asked, solvers, change), sessions);
}

}  // namespace ikbench::compare
