// A study, a user's file or two groups, judged: what tables, figures, screens and claims are made of.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "analysis/judge/data/sampling.hpp"
#include "analysis/judge/statistics/compare_pairs.hpp"
#include "analysis/judge/statistics/descriptives.hpp"

namespace ikbench::judge {

struct JudgedMetric {
  MetricSamples samples;
  AnalysisPlan plan;                       // by which it was judged
  std::vector<Descriptives> descriptives;  // one for each group
  std::vector<Comparison> comparisons;     // one for each pair of the plan
};

// Describes the groups and adds the doubts of the findings, which are those of `compare`.
JudgedMetric judge(MetricSamples samples, const AnalysisPlan& plan, std::vector<Comparison> comparisons);
// The same, with findings of these observations alone.
JudgedMetric judge(MetricSamples samples, const AnalysisPlan& plan);

// What tables, sentences and figures tell of a group: the mean of shares and where the plan compares means, else the
// median; NaN where values are lost.
double average_of(const JudgedMetric& judged, std::size_t group);
// Groups: those whom nobody beats, if each of them beats all others, the others by value, of equal ones that with fewer
// evaluations (a metric of `all`), those that lost values.
std::vector<std::size_t> display_order(const JudgedMetric& judged, const std::vector<JudgedMetric>& all);

struct JudgedStudy {
  StudyResults study;
  // Those of reports, in the order of metrics.inc, if the study has them; and the deciding one. Where any target is
  // solved no other error: solved says which are small enough.
  std::vector<JudgedMetric> metrics;
  std::size_t primary = 0;  // metric of the headline: the plan's, else solved where any target is solved, else error
  std::vector<Warning> warnings;  // of the whole study
};

// Without descriptions and findings.
JudgedStudy make_all_samples(StudyResults study);
// Every pair has one p in a metric, whatever else is asked of the store: with the pairs of the study's own labels and
// the metrics that its plan names. Pairs with a label of another machine (beside.hpp) are a family of their own.
JudgedStudy judge(StudyResults study);

// The names of the metrics that share the significance: the plan's `metric` (else "solved", or "error" without a
// tolerance), and each word of `then` for another one.
std::vector<std::string> names_in_plan(const results::StudyDefinition& study);
// By which of these names the plan names a metric of this study; empty: by none.
std::string name_in_plan(const JudgedStudy& study, const JudgedMetric& metric);

// Null if the study has no such metric, by its column.
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
