// Compares what solvers spend until a solve succeeds, by their expected running times, with intervals over clusters
// (clusters.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/finding.hpp"
#include "analysis/statistics/running_time.hpp"

namespace ikbench::inference {

struct SolverCost {
  statistics::RunningTime time = {};
  std::vector<statistics::RunningTime> replicates = {};  // empty if there are too few clusters
  std::string undefined = {};                            // the reason if there is no running time

  Estimate expected(const Clusters& clusters) const;  // expected running time
};
// Returns the costs in the order of the study's solvers. A solve that is not ok is given up at its cost.
std::vector<SolverCost> costs_of(const StudyResults& study, Metric cost, const Clusters& clusters);

// Returns the pairs to compare: all, or with more than twenty solvers only those with the best.
std::vector<std::pair<std::size_t, std::size_t>> compared_pairs(std::size_t solvers, std::size_t best);

// Ratios of expected running times; better: the first spends less. A sample without a success has an infinite running
// time and no ratio. Such a pair has no interval, and shares of success decide, each weighed by what the other spends:
// p2 c1 - p1 c2 has the sign of c1 / p1 - c2 / p2. A solver that never succeeds has an infinite cost.
std::vector<Finding> compare_costs(const StudyResults& study, Metric cost, const Clusters& clusters);

}  // namespace ikbench::inference
