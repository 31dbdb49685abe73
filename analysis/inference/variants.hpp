// A candidate B held against its baseline A: the solves of both make a study of two solvers, which is judged as a
// report judges any study (judged_study.hpp).
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
  std::vector<results::Session> sessions = {};  // of its store
  // Passes on the solves of the label by run and point.
  std::function<void(const std::function<void(results::SolveRecord)>& take)> each_solve;
};

// One for each label of the study, in its order. `store` outlives them.
std::vector<Variant> variants(const results::Store& store, const results::StudyEntry& study);

struct VariantPair {
  const Variant& a;
  const Variant& b;
};

// The solves of both, by the solvers "A" and "B", and what decides whether their times can be compared.
struct VariantStudy {
  std::string label;
  StudyResults study;
  Doubts times_differ;      // why times cannot be compared; none where they can
  std::string differences;  // between A and B, beside their numbers
};

// Everything of the study's definition and plan is A's, but for the plan's margins, significance and power, which are
// those of `plan`. std::invalid_argument where one side has no complete run, or the two were not given the same to do:
// another robot, other targets, another configuration to start from.
VariantStudy study_of_both(const VariantPair& pair, const results::AnalysisPlan& plan);

// What is known of B against A by one metric.
struct MetricComparison {
  Metric metric;
  results::Estimand estimand = results::Estimand::mean;
  int n_a = 0, n_b = 0;
  double mean_a = statistics::not_defined, mean_b = statistics::not_defined;
  std::string_view observation = "run";    // what one value is of: "run" or "target"
  Contrast contrast = {};                  // of A and B, in this order; its p is not corrected
  double level = statistics::not_defined;  // that p is below where the two differ; the interval is of 1 - level
  bool is_compared = true;                 // else `remark` says why not
  bool is_by_ranks = false;                // its test compares no means
  bool is_counted = true;  // false: evaluations that nobody counted, which is no failure of a comparison
  std::string remark = {};
};

// B is shown to be worse by more than the margin.
bool is_regression(const MetricComparison& metric);
// Neither shown to be worse by more than the margin, nor not to be.
bool is_open(const MetricComparison& metric);

struct VariantComparison {
  std::string label;
  std::string design;  // what an observation is, and whether observations are compared in pairs
  std::vector<MetricComparison> metrics;
  std::vector<std::string> notes;  // what is left out, and in what the two differ beside their numbers
};

// Whether it holds for any metric of any label.
template <class Is>
bool any_metric(std::span<const VariantComparison> comparisons, Is is) {
  return std::ranges::any_of(comparisons,
                             [&](const VariantComparison& each) { return std::ranges::any_of(each.metrics, is); });
}

// `level_of` turns a significance level into that of one look; the identity where there is one look alone.
using LevelOf = std::function<double(double)>;

// The metrics named, or where none is those of compared_metrics(), and of poses the orientation error: the mean of
// each, unless the plan has it by another estimand alone. The plan's test decides each, at the levels of Holm's
// correction over all labels and metrics, so that any finding among those where A and B do not differ has the
// probability `significance` at most. std::invalid_argument for an unknown metric.
std::vector<VariantComparison> compare_variants(
    std::span<const VariantStudy> studies, std::span<const std::string> metrics,
    const LevelOf& level_of = [](double level) { return level; });

}  // namespace ikbench::inference
