// The one door from solves to numbers that are compared: what is odd becomes a doubt here, and what passes is finite.
// Metrics are the table of metrics.inc.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/data/study_results.hpp"

namespace ikbench::judge {

// share: solved or not. error: a distance from the target. cost: effort for an answer; with a tolerance, only of
// targets that both solvers of a pair solved. spent: all that attempts took, by the number of targets solved, so that
// who fails pays for it. run: its last solve has the value of all. Shares have a scale of their own, what a check gives
// differences, all others ratios.
enum class MetricKind { success_rate, error, cost, ert, per_run };

// In which reports: where a study has a tolerance, costs are of what was solved; if some of it was not, what was spent
// stands in place of evaluations and time.
enum class WhenReported { always, if_all_solve, if_some_fail, if_asked };

struct Metric {
  std::string_view column;  // name in files and on the command line
  std::string_view slug;    // of files and anchors
  std::string_view name;    // in text
  std::string_view unit;    // of its values; empty: none
  MetricKind kind;
  QuantityKind quantity_kind;
  double floor;       // of ratios: a smaller value counts as this
  double resolution;  // values that differ by no more are equal
  WhenReported when_reported;
  double (*value_of)(const SolveSummary& solve,
                     const StudyResults& study);  // NaN: the solve has none; null: of the check
  std::size_t number = 0;                         // its place among those of the check
  Better better = kind == MetricKind::success_rate ? Better::larger : Better::smaller;

  double value(const SolveSummary& solve, const StudyResults& study) const;
};

std::span<const Metric> metrics();
// With the numbers of a study's check, which it outlives. Throws std::invalid_argument if one has a metric's name.
std::vector<Metric> metrics_of(const results::StudySpec& study);
// Throws std::invalid_argument, which lists all, if no row has this column.
const Metric& metric_named(std::string_view column, std::span<const Metric> all = metrics());

// Its unit of comparison is a session, since what decides a time is drawn once for a process: memory, hashes, cores.
inline bool is_time_metric(const Metric& metric) { return metric.quantity_kind == QuantityKind::time; }
// Of several solves in an observation the median counts, else the mean.
inline bool uses_medians(const Metric& metric) { return is_time_metric(metric) && metric.kind == MetricKind::cost; }

// Without groups, and what a study adds.
MetricSamples empty_samples(const Metric& metric);
// One observation is a run, the mean of its targets, where solves are chained or all runs have one target; else a
// target, the mean of its runs, or of drawn targets its one solve. Of times it is a session: the logarithm of the
// median over its targets, or its part in that of all time spent by all targets solved.
MetricSamples make_samples(const StudyResults& study, const Metric& metric);
// As papers print it: times, too, are of runs or targets, of each the median. Describes, and compares no times.
MetricSamples make_samples_by_target(const StudyResults& study, const Metric& metric);

}  // namespace ikbench::judge
