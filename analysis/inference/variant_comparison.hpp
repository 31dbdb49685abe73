// Compares variants: the engine of reports with two groups, a family of metrics, and levels by look while runs grow.
#pragma once

#include <algorithm>
#include <functional>
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

// Turns a significance level into the level of one look; the identity if there is only one look.
using LevelOf = std::function<double(double)>;

// Compares the named metrics. If none is named, compares compared_metrics() and, for poses, the orientation error.
// Takes the mean of each metric, unless the plan asks for another estimand only. The plan's test decides each, at
// Holm's levels over all labels and metrics: the probability of any false finding is at most `significance`. Throws
// std::invalid_argument for an unknown metric.
std::vector<VariantComparison> compare_variants(
    std::span<const VariantStudy> studies, std::span<const std::string> metrics,
    const LevelOf& level_of = [](double level) { return level; });

// The looks, planned before the runs are seen: after `step` runs, 2 `step`, ..., `most`.
struct Looks {
  int step = 5;
  int most = 50;
};
// Throws std::invalid_argument unless there are 1 to 20 looks, each at 2 runs or more, the last after all runs.
void check_looks(const Looks& looks);

// settled: something is worse, or nothing is open. at_limit: neither, after `most` runs. open: more runs are needed.
enum class LookState { settled, open, at_limit };

struct SequentialComparison {
  std::vector<VariantComparison> comparisons;  // those of the look that settles, or of the last look
  int runs = 0;                                // number of runs at that look
  LookState state = LookState::open;
};

// Calls compare_variants on the first runs of both at each look, at the look's level
// (analysis/statistics/group_sequential.hpp), so that all looks together make false findings as rarely as a single one.
// A decision of a look stays. `earlier` has the looks that were made already. Later runs than the settling look's are
// ignored, so the answer does not depend on them. Throws std::invalid_argument as check_looks does, if more runs give
// no more observations (targets of a path, each solved alone), or if the first look lacks complete runs.
SequentialComparison compare_sequentially(std::span<const VariantStudy> studies, std::span<const std::string> metrics,
                                          const Looks& looks, SequentialComparison earlier = {});

}  // namespace ikbench::inference
