// Compares a candidate B with its baseline A. The solves of both make a study of two solvers, which is judged like any
// study (judged_study.hpp).
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/study.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// One label of a study.
struct Variant {
  results::StudyEntry study;
  results::Series series;
  std::vector<results::Session> sessions = {};  // sessions of the store that has the label
  // Passes each solve of the label to `take`, ordered by run and point.
  std::function<void(const std::function<void(results::SolveRecord)>& take)> each_solve;
};

// Returns one variant per label, in the order of the study. `store` must outlive them.
std::vector<Variant> variants(const results::Store& store, const results::StudyEntry& study);

// The solves of both, as solvers "A" and "B", and the reasons not to compare their times.
struct VariantStudy {
  std::string label;
  StudyResults study;
  Doubts times_differ;      // reasons not to compare times; empty if they are comparable
  std::string differences;  // settings, program and machine that differ between A and B
};

// Takes the definition and plan of A, but margins, significance, power and estimands from `plan`. Throws
// std::invalid_argument if one side has no complete run, or if robot, targets or start configurations differ.
VariantStudy study_of_both(const Variant& a, const Variant& b, const results::AnalysisPlan& plan);

// The comparison of B with A by one metric.
struct MetricComparison {
  Metric metric;
  results::Estimand estimand = results::Estimand::mean;
  ValueScale scale = ValueScale::plain;
  int n_a = 0, n_b = 0;
  double mean_a = statistics::not_defined, mean_b = statistics::not_defined;
  std::string_view observation = "run";    // unit of one value: "run" or "target"
  Finding contrast = {};                  // A is first, B second; p is not corrected
  double level = statistics::not_defined;  // the two differ if p is below it; the interval has the level 1 - level
  bool is_compared = true;                 // if false, `remark` says why
  bool is_by_ranks = false;                // the test compares ranks, not means
  bool is_counted = true;                  // false: nobody counted the evaluations; the comparison does not fail for it
  std::string remark = {};
};

// Returns whether B is shown to be worse by more than the margin.
bool is_regression(const MetricComparison& metric);
// Returns whether the data do not show either way if B is worse by more than the margin.
bool is_open(const MetricComparison& metric);

struct VariantComparison {
  std::string label;
  std::string design;  // says what an observation is, and whether observations are paired
  std::vector<MetricComparison> metrics;
  std::vector<std::string> notes;  // say what is left out, and which settings differ
};

// Returns whether `is` holds for any metric of any label.
template <class Is>
bool any_metric(std::span<const VariantComparison> comparisons, Is is) {
  return std::ranges::any_of(comparisons,
                             [&](const VariantComparison& each) { return std::ranges::any_of(each.metrics, is); });
}

// Turns a significance level into the level of one look; the identity if there is only one look.
using LevelOf = std::function<double(double)>;

// Compares the named metrics. If none is named, compares compared_metrics() and, for poses, the orientation error.
// Takes the mean of each metric, unless the plan asks for another estimand only. The plan's test decides each, at
// Holm's levels over all labels and metrics: the probability of any false finding is at most `significance`. Throws
// std::invalid_argument for an unknown metric.
std::vector<VariantComparison> compare_variants(
    std::span<const VariantStudy> studies, std::span<const std::string> metrics,
    const LevelOf& level_of = [](double level) { return level; });

}  // namespace ikbench::inference
