#include "analysis/inference/variant_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/margin.hpp"

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

// A metric that needs a test, which is made at several levels.
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
void decide(std::vector<Open>& all, double significance) {
  auto left = static_cast<double>(all.size());
  for (Open& each : all) each.test(significance / left);
  std::ranges::stable_sort(all, {}, &Open::p);
  for (Open& each : all) {
    if (const double level = significance / left; level > each.row->level()) each.test(level);
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
                                                std::span<const std::string> metrics) {
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
  if (!open.empty()) decide(open, studies.front().study.plan.significance);
  return result;
}

}  // namespace ikbench::inference
