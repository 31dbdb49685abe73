// Compares variants: the engine of reports with two groups, and a family of metrics.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/inference/variants.hpp"

namespace ikbench::inference {

// The comparison of B with A by one metric.
struct MetricComparison {
  Metric metric;
  results::Estimand estimand = results::Estimand::mean;
  Observations observed = {};
  // Judges A, the first group, and B as a report does; but p is not corrected, and the two differ if it is below the
  // plan's significance, which is the level of this metric. Without findings if the two are not compared.
  Evidence evidence = {};
  Doubts why_not = {};       // why the two are not compared, if something is wrong with their values
  bool is_counted = true;    // false: nobody counted the evaluations; the comparison does not fail for it
  std::string refused = {};  // why the plan has no margin for these values

  bool is_compared() const { return !evidence.contrasts.empty(); }
  Finding finding() const { return is_compared() ? evidence.contrasts.front() : Finding{}; }
  double level() const { return evidence.plan.significance; }
};

// Returns whether B is shown to be worse by more than the margin.
bool is_regression(const MetricComparison& metric);
// Returns whether the data do not show either way if B is worse by more than the margin.
bool is_open(const MetricComparison& metric);

struct VariantComparison {
  std::string label;
  bool is_of_two = false;  // two solvers, not two variants of one
  std::vector<MetricComparison> metrics = {};
  std::vector<std::string> notes = {};  // say what is left out, and which settings differ
  std::string failures = {};            // a note too: how many solves of each have no answer
};

// Returns whether `is` holds for any metric of any label.
template <class Is>
bool any_metric(std::span<const VariantComparison> comparisons, Is is) {
  return std::ranges::any_of(comparisons,
                             [&](const VariantComparison& each) { return std::ranges::any_of(each.metrics, is); });
}

// Compares the named metrics. If none is named, compares compared_metrics() and, for poses, the orientation error.
// Takes the mean of each metric, unless the plan asks for another estimand only. The plan's test decides each, at
// Holm's levels over all labels and metrics: the probability of any false finding is at most `significance`. Throws
// std::invalid_argument for an unknown metric.
std::vector<VariantComparison> compare_variants(std::span<const VariantStudy> studies,
                                                std::span<const std::string> metrics);

}  // namespace ikbench::inference
