// Hand-made studies.
#pragma once

#include <fmt/ranges.h>

#include "analysis/judge/data/sampling.hpp"
#include "analysis/judge/judge.hpp"
#include "analysis/judge/regression.hpp"
#include "analysis/judge/statistics/compare_pairs.hpp"
#include "analysis/judge/statistics/descriptives.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"
#include "base/units.hpp"
#include "tests/stored_study.hpp"

using namespace ikbench::judge;

namespace ikbench::judge {

using results::CountedBy;
using results::SolveRecord;
using results::Status;
using results::Timing;

// The kind of values whose effects have this scale.
inline SampleKind kind_with(EffectScale scale, double floor = 0) {
  switch (scale) {
    case EffectScale::ratio:
      return Ratios{.floor = floor};
    case EffectScale::difference:
      return Differences{};
    case EffectScale::share:
      break;
  }
  return Proportions{};
}

// A finding with all that some kinds of findings have.
enum class ResultKind { tested, missing, apart, deterministic, too_few, few_decide };
struct FlatComparison : Comparison {
  std::optional<double> estimate = {}, p = {}, effect = {};
  std::optional<Interval> interval = {};
  std::string_view test = {};
  Verdict verdict = Verdict::not_tested;
  ResultKind why = ResultKind::tested;
  bool is_within_margin = false, are_all_equal = false;
  int n = 0, needed = 0;
};
inline FlatComparison flat(const Comparison& comparison) {
  FlatComparison all{comparison};
  all.verdict = verdict_of(comparison);
  all.are_all_equal = all_values_equal(comparison);
  if (const auto& amount = comparison.estimate) all.estimate = amount->value, all.interval = amount->interval;
  if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) {
    all.p = tested->adjusted_p, all.test = tested->test, all.n = tested->n;
    all.is_within_margin = tested->is_below_margin || tested->verdict == Verdict::equivalent;
    if (tested->dominance) all.effect = tested->dominance->a12();
  } else if (const auto* const open = std::get_if<NotTested>(&comparison.result)) {
    all.n = open->n, all.needed = open->required_n;
    all.why = open->reason == NotTestedReason::sample_too_small ? ResultKind::too_few
              : open->reason == NotTestedReason::missing_values ? ResultKind::missing
              : open->reason == NotTestedReason::dominated      ? ResultKind::few_decide
                                                                : ResultKind::apart;
  } else {
    all.why = ResultKind::deterministic;
  }
  return all;
}
inline std::vector<FlatComparison> compared(const MetricSamples& samples, const AnalysisPlan& plan,
                                            std::size_t metrics = 1) {
  std::vector<FlatComparison> all;
  for (const Comparison& comparison : compare_pairs(samples, plan, metrics)) all.push_back(flat(comparison));
  return all;
}
inline FlatComparison better_first(const FlatComparison& all, std::string_view control) {
  return flat(judge::better_first(static_cast<const Comparison&>(all), control));
}
inline Sample& sample_of(Group& group) { return std::get<Sample>(group.sample); }
inline std::vector<double>& values_in(Group& group) { return std::get<Sample>(group.sample).values; }
inline std::vector<double> list_of(const Group& group) { return {values_of(group).begin(), values_of(group).end()}; }

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
          .session = run};
}

// Changes a solve after its defaults are set.
using Change = std::function<void(SolveRecord&)>;

inline std::vector<SolveRecord> planned_solve_count(const Asked& asked, const std::vector<std::string>& solvers,
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
  results::StoredStudy entry{
      .name = "hand-made", .definition = results::parse_definition(definition(asked)), .series = {}};
  for (const std::string& solver : solvers)
    entry.series.push_back({.key = solver + "@1", .label = solver, .algorithm = solver, .options = "{}"});
  return entry;
}

// One for each run, as a study makes them.
inline std::vector<results::Session> sample_sessions(int runs) {
  std::vector<results::Session> all;
  for (int run = 1; run <= runs; ++run) all.push_back({.id = run, .environment = {{"cpu", "one"}, {"state", "first"}}});
  return all;
}

inline StudyResults study(const Asked& asked, const Change& change,
                          const std::vector<std::string>& solvers = {"A", "B"},
                          const std::vector<results::Session>& sessions = {}) {
  return to_stored(entry_of(asked, solvers), planned_solve_count(asked, solvers, change),
                   sessions.empty() ? sample_sessions(asked.runs) : sessions);
}

}  // namespace ikbench::judge
