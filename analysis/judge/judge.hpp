// Judges metrics: describes their groups, compares them, and adds warnings. Tables, figures, screens and claims of
// papers are made of a JudgedMetric or a JudgedStudy. A study costs 150 bytes per solve and about 10 ms per pair of
// solvers with thousands of values. docs/explanation/methods.md says how metrics are judged.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "analysis/judge/data/sampling.hpp"
#include "analysis/judge/requirement.hpp"
#include "analysis/judge/solved_targets.hpp"
#include "analysis/judge/statistics/compare_pairs.hpp"
#include "analysis/judge/statistics/descriptives.hpp"

namespace ikbench::judge {

// The samples of one metric with what was found in them.
struct JudgedMetric {
  MetricSamples samples;
  AnalysisPlan plan;                       // the rules by which the metric was judged
  std::vector<Descriptives> descriptives;  // one per group
  std::vector<Comparison> comparisons;     // one per pair of the plan
};

// Describes the groups, and adds the warnings that follow from the comparisons. The comparisons were made by
// `compare_pairs`, also as parts of a larger family, and their indices are those of groups of the samples.
JudgedMetric judge(MetricSamples samples, const AnalysisPlan& plan, std::vector<Comparison> comparisons);
// Compares and judges samples by themselves.
JudgedMetric judge(MetricSamples samples, const AnalysisPlan& plan);

// Returns the average of a group in tables, sentences and figures: the mean of proportions and of plans that compare
// means, otherwise the median. NaN if values are missing.
double average_of(const JudgedMetric& judged, std::size_t group);
// Returns the groups in the order of display. Unbeaten groups come first, if they beat all others; then the groups by
// their averages, and those with equal averages by their evaluations, which are one of `metrics`. Groups with missing
// values come last.
std::vector<std::size_t> display_order(const JudgedMetric& judged, const std::vector<JudgedMetric>& metrics);

// A study with all of its reported metrics.
struct JudgedStudy {
  StudyResults study;
  // The deciding metric and those that reports show, in the order of metrics.inc. If any target was solved, no other
  // error is among them, because "solved" says which errors are small enough.
  std::vector<JudgedMetric> metrics;
  std::size_t primary = 0;        // index of the deciding metric: the plan's; otherwise solved, or error if none was
  std::vector<Warning> warnings;  // about the whole study
  std::vector<RequirementCheck> requirements = {};  // made by check_requirements if the command asks for them
  SolvedTargets targets = {};                       // made by `judge`
};

// Makes the samples of all reported metrics, without descriptives and comparisons.
JudgedStudy make_all_samples(StudyResults study);
// Judges all reported metrics. A pair has the same p whatever else is asked of the store: its family are the pairs of
// the study's own labels in the metrics that the plan names. Pairs with an imported label (data/imported.hpp) are a
// family of their own.
JudgedStudy judge(StudyResults study);

// Returns the names of the metrics that share the significance: first the plan's metric, otherwise "solved", or "error"
// if the study has no tolerance; then each tie-breaker that names another metric.
std::vector<std::string> names_in_plan(const results::StudyDefinition& study);
// Returns by which of these names the plan names a metric of this study; empty if the plan does not name the metric.
std::string name_in_plan(const JudgedStudy& study, const JudgedMetric& metric);

// Returns the metric with this column; null if the study has no such metric. Throws std::invalid_argument if no metric
// has the column.
const JudgedMetric* find_metric(const JudgedStudy& judged, std::string_view column);
// Returns the comparison of two groups, in either order; null if the plan has no such pair. Searches all pairs: code
// that asks for many of them makes a ComparisonTable.
const Comparison* find_comparison(const JudgedMetric& judged, std::string_view one, std::string_view other);

// The comparisons of one metric by the indices of their groups, for code that asks for many pairs. Takes one pointer
// per pair of groups. Refers to the comparisons of the metric, which must not be changed while the table is in use.
class ComparisonTable {
 public:
  explicit ComparisonTable(const JudgedMetric& judged);
  // Returns the comparison of two groups, in either order; null if the plan has no such pair.
  const Comparison* find(std::size_t first, std::size_t second) const;
  // Returns the verdict of the first group against the second; not_tested if the plan has no such pair.
  Verdict verdict(std::size_t first, std::size_t second) const;

 private:
  std::size_t groups_;
  std::vector<const Comparison*> cells_;  // row by row, each pair twice
};

}  // namespace ikbench::judge
