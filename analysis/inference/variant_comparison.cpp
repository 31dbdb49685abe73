#include "analysis/inference/variant_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/margin.hpp"
#include "analysis/statistics/group_sequential.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// The named metrics, in the order given, each once; if none is named, for poses the orientation error too.
std::vector<Metric> asked_metrics(std::span<const std::string> names, std::span<const VariantStudy> studies) {
  std::vector<Metric> result;
  for (const std::string& name : names) {
    const Metric metric = metric_named(name);
    if (std::ranges::find(result, metric) == result.end()) result.push_back(metric);
  }
  if (!result.empty()) return result;
  result = compared_metrics();
  const auto is_of_poses = [](const VariantStudy& of) { return of.study.facts.pose; };
  if (std::ranges::any_of(studies, is_of_poses)) result.insert(result.begin() + 1, Metric::orientation_error_deg);
  return result;
}

// A metric that needs a test, which may be made at several levels.
struct Open {
  MetricComparison* row;
  AnalysisPlan plan;

  void test(double level) {
    constexpr double least_level = 1e-6;  // the bootstrap resolves no smaller one, and 1 - level must be below 1
    if (level >= least_level) {
      plan.significance = level;
      row->evidence = evidence(row->observed, plan);
      return;
    }
    row->evidence = described(row->observed, plan);
    row->evidence.plan.significance = level;
    row->evidence.contrasts = {{.second = 1, .relation = Relation::undecided}};
  }
  double p() const {
    const double p = row->finding().p;
    return std::isnan(p) ? 2 : p;
  }
};

// Settles a metric that needs no test, and returns the plan for the test of another.
std::optional<AnalysisPlan> examine(MetricComparison& row, const VariantStudy& of, std::vector<std::string>& notes) {
  const StudyResults& study = of.study;
  const std::vector<Estimand> planned = estimands_of(study, row.metric);
  const Estimand average = average_estimand(row.metric);
  row.estimand = std::ranges::find(planned, average) == planned.end() ? planned.front() : average;
  row.observed = observations(study, row.metric, row.estimand);
  const Observations& observed = row.observed;
  if (row.metric == Metric::solved && !std::isfinite(tolerance_cm(study)))
    notes.push_back(words_of(Doubt{.kind = DoubtKind::no_tolerance}));
  std::ranges::copy(observed.notes, std::back_inserter(notes));
  const bool is_time = info_of(row.metric).kind == Kind::time;
  const Doubts& why_not = is_time && !of.times_differ.empty() ? of.times_differ : observed.flaws;
  if (!why_not.empty() || observed.groups.size() < 2) {
    const auto has_nobody = [&](const Solve& solve) { return solve.counted_by == CountedBy::nobody; };
    row.is_counted = row.metric != Metric::evaluations || std::ranges::none_of(study.solves, has_nobody);
    row.why_not = why_not + left_out(study, row.metric);
    std::ranges::move(list_of(why_not), std::back_inserter(notes));
    return std::nullopt;
  }
  std::ranges::copy(observed.counting, std::back_inserter(notes));
  try {
    check_margin(observed, study.plan);
  } catch (const std::invalid_argument& no_margin) {
    row.refused = no_margin.what();
    return std::nullopt;
  }
  const AnalysisPlan plan = feasible(study.plan, observed);
  if (!is_fact(observed.groups.front(), observed.groups.back())) return plan;
  row.evidence = evidence(observed, plan);
  return std::nullopt;
}

// Holm (Scandinavian J. Statistics 6 (1979) 65): the smallest p is tested at significance / m, the next at
// significance / (m - 1), and so on until one is not below. The others are left at the level of that one.
void decide(std::vector<Open>& all, double significance, const LevelOf& level_of) {
  auto left = static_cast<double>(all.size());
  for (Open& each : all) each.test(level_of(significance / left));
  std::ranges::stable_sort(all, {}, &Open::p);
  for (Open& each : all) {
    if (const double level = level_of(significance / left); level > each.row->level()) each.test(level);
    if (each.p() < each.row->level()) --left;
  }
}

// "Solves without an answer: none of A's 16; 3 of B's 16 (crashed 1, timed_out 2)."; empty if every solve has one.
std::string failures_note(const StudyResults& study) {
  std::vector<std::string> sides;
  int all = 0;
  for (const SolverCounts& count : counts(study)) {
    int failures = 0;
    std::vector<std::string> kinds;
    for (const Status status : count.without_answer()) {
      failures += count.of(status);
      kinds.push_back(fmt::format("{} {}", name_of(status), count.of(status)));
    }
    all += failures;
    sides.push_back(failures == 0 ? fmt::format("none of {}'s {}", count.solver, count.solves)
                                  : fmt::format("{} of {}'s {} ({})", failures, count.solver, count.solves,
                                                fmt::join(kinds, ", ")));
  }
  return all == 0 ? "" : fmt::format("Solves without an answer: {}.", fmt::join(sides, "; "));
}

// Number of runs, from the first, that both have solved completely.
int runs_in_common(const StudyResults& study) {
  std::map<int, int> solves;
  for (const Solve& solve : study.solves) ++solves[solve.run];
  int run = 0;
  while (solves.contains(run + 1) && solves[run + 1] == 2 * study.points) ++run;
  return run;
}

std::vector<VariantStudy> first_runs(std::span<const VariantStudy> all, int runs) {
  std::vector<VariantStudy> result(all.begin(), all.end());
  for (VariantStudy& each : result) {
    std::erase_if(each.study.solves.to_change(), [&](const Solve& solve) { return solve.run > runs; });
    each.study.runs = runs;
  }
  return result;
}

// Keeps what an earlier look decided. A fact of the first runs does not settle later ones.
void keep_settled(std::vector<VariantComparison>& now, const std::vector<VariantComparison>& before) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t m = 0; m < before[i].metrics.size(); ++m) {
      const MetricComparison& metric = before[i].metrics[m];
      if (metric.is_compared() && !metric.finding().is_fact && !is_open(metric)) now[i].metrics[m] = metric;
    }
  }
}

}  // namespace

bool is_regression(const MetricComparison& metric) {
  const Finding finding = metric.finding();
  return finding.relation == Relation::better && finding.is_beyond_margin();
}

bool is_open(const MetricComparison& metric) {
  if (!metric.is_compared()) return metric.is_counted;
  const Finding finding = metric.finding();
  return finding.relation == Relation::undecided || finding.relation == Relation::undefined ||
         (finding.relation == Relation::better && !finding.is_within_margin() && !finding.is_beyond_margin());
}

std::vector<VariantComparison> compare_variants(std::span<const VariantStudy> studies,
                                                std::span<const std::string> metrics, const LevelOf& level_of) {
  const std::vector<Metric> asked = asked_metrics(metrics, studies);
  std::vector<VariantComparison> result;
  std::vector<Open> open;
  for (const VariantStudy& of : studies) {
    VariantComparison& comparison =
        result.emplace_back(VariantComparison{.label = of.label, .is_of_two = of.is_of_two});
    std::vector<std::string> notes;
    comparison.metrics.reserve(asked.size());
    for (const Metric metric : asked) {
      MetricComparison& row = comparison.metrics.emplace_back(MetricComparison{.metric = metric});
      if (const auto plan = examine(row, of, notes)) open.push_back({&row, *plan});
    }
    comparison.failures = failures_note(of.study);
    notes.push_back(comparison.failures);
    notes.push_back(of.differences);
    for (std::string& note : notes) {
      if (std::ranges::find(comparison.notes, note) == comparison.notes.end())
        comparison.notes.push_back(std::move(note));
    }
  }
  if (!open.empty()) decide(open, studies.front().study.plan.significance, level_of);
  return result;
}

void check_looks(const Looks& looks) {
  constexpr int most_looks = 20;
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(
        fmt::format("looks after every {} of at most {} runs: {}", looks.step, looks.most, what));
  };
  if (looks.step < 2) refuse("--step is at least 2, because a single run shows no variation");
  if (looks.most < looks.step || looks.most % looks.step != 0) refuse("--max-runs is a multiple of --step");
  if (looks.most / looks.step > most_looks) {
    refuse(fmt::format("there are at most {} looks; choose a larger --step", most_looks));
  }
}

SequentialComparison compare_sequentially(std::span<const VariantStudy> studies, std::span<const std::string> metrics,
                                          const Looks& looks, SequentialComparison earlier) {
  check_looks(looks);
  int available = looks.most;
  for (const VariantStudy& each : studies) {
    if (blocks_of(each.study) == Blocks::path_targets && each.study.points > 1) {
      throw std::invalid_argument(
          "--sequential adds runs, but here an observation is a target of the path, and runs add no targets; compare "
          "without it");
    }
    available = std::min(available, runs_in_common(each.study));
  }
  if (available < looks.step) {
    throw std::invalid_argument(
        fmt::format("A and B have {} complete runs in common, and the first look is after {}", available, looks.step));
  }
  const Boundary boundary{.looks = looks.most / looks.step};
  std::map<double, double> constants;  // by level
  const auto level_of = [&](double level, int look) {
    const auto [known, is_new] = constants.try_emplace(level);
    if (is_new) known->second = constant_of(level / 2, boundary);
    return 2 * level_of_look(known->second, look, boundary);
  };
  SequentialComparison result = std::move(earlier);
  for (int look = result.runs / looks.step + 1; look * looks.step <= available && result.state != LookState::settled;
       ++look) {
    result.runs = look * looks.step;
    std::vector<VariantComparison> now = compare_variants(first_runs(studies, result.runs), metrics,
                                                          [&](double level) { return level_of(level, look); });
    keep_settled(now, result.comparisons);
    result.comparisons = std::move(now);
    const auto is_waited_for = [](const MetricComparison& metric) { return metric.is_compared() && is_open(metric); };
    if (any_metric(result.comparisons, is_regression) || !any_metric(result.comparisons, is_waited_for)) {
      result.state = LookState::settled;
    }
  }
  if (result.state == LookState::open && result.runs == looks.most) result.state = LookState::at_limit;
  return result;
}

}  // namespace ikbench::inference
