// Turns the solves of a study into samples of metrics. This is the only place that does: incomparable solves become
// warnings here, and every value that leaves is finite. The metrics are the table of metrics.inc and the numbers of a
// study's own check. docs/explanation/methods.md says what a value of each metric is made of.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/data/study_results.hpp"

namespace ikbench::judge {

// How values are made of solves, and how they are compared.
enum class MetricKind {
  success_rate,  // solved or not; compared as proportions
  error,         // distance from the target
  cost,          // effort for an answer; with a tolerance, only of targets that both solvers of a pair solved
  ert,           // expected running time: cost of all attempts per success, so that failed attempts count
  per_run        // one value per run, which is the value of its last solve
};

// When a report shows a metric that does not decide.
enum class WhenReported {
  always,
  if_all_solve,  // the study has no tolerance, no target was solved, or all were
  if_some_fail,  // some targets were solved, and some were not
  if_asked       // never, unless the plan names the metric as the deciding one
};

// One row of the table of metrics.
struct Metric {
  std::string_view column;  // name in files and on the command line
  std::string_view slug;    // name in files and anchors of a report
  std::string_view name;    // name in text
  std::string_view unit;    // empty: none
  MetricKind kind;
  QuantityKind quantity_kind;
  double floor;       // where ratios are compared, a smaller value counts as this
  double resolution;  // values that differ by no more are equal
  WhenReported when_reported;
  double (*value_of)(const SolveSummary& solve, const StudyResults& study);  // null: a number of the study's check
  std::size_t number = 0;                                                    // index among the numbers of the check
  Better better = kind == MetricKind::success_rate ? Better::larger : Better::smaller;

  // Returns the value of a solve; NaN if the solve has none.
  double value(const SolveSummary& solve, const StudyResults& study) const;
};

// Returns the metrics of metrics.inc.
std::span<const Metric> metrics();
// Returns these metrics and the numbers of a study's check, whose names belong to the study. Throws
// std::invalid_argument if such a number has the name of a metric.
std::vector<Metric> metrics_of(const results::StudySpec& study);
// Returns the metric with this column. Throws std::invalid_argument, which lists all columns, if no metric has it.
const Metric& metric_named(std::string_view column, std::span<const Metric> all = metrics());

// Returns whether a metric is made of times. Times are compared by session, not by solve: memory layout, hash seeds and
// core are drawn once per process, so that solves of one session are not independent.
inline bool is_time_metric(const Metric& metric) { return metric.quantity_kind == QuantityKind::time; }
// Returns whether the median of the solves of a value counts, and not their mean.
inline bool uses_medians(const Metric& metric) { return is_time_metric(metric) && metric.kind == MetricKind::cost; }

// Returns samples of a metric without groups, and without what depends on a study.
MetricSamples empty_samples(const Metric& metric);
// Returns the samples of a metric. If solves are chained, or all runs have one target, a value is a run: the mean of
// its targets. Otherwise a value is a target: the mean of its runs, or the only solve of a drawn target. A value of
// times is a session: the logarithm of the median of its solves, or its part in the time of all attempts per success.
// Groups whose values must not be compared are excluded, and the warnings say why.
MetricSamples make_samples(const StudyResults& study, const Metric& metric);
// Returns the samples of a metric by run or target, as papers print them; times are medians. Times of these samples are
// only for description, not for comparison.
MetricSamples make_samples_by_target(const StudyResults& study, const Metric& metric);

}  // namespace ikbench::judge
