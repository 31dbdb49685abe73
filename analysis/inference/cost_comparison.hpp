// What solvers spend until a solve succeeds, with intervals over clusters (clusters.hpp), and
// which of two spends less: by their expected running times.
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
  std::vector<statistics::RunningTime> replicates = {};  // none where there are too few clusters
  std::string undefined = {};                            // why there is no running time; empty where there is

  Estimate expected(const Clusters& clusters) const;  // expected running time
};
// In the order of the study's solvers. A solve that is not ok is given up at its cost.
std::vector<SolverCost> costs_of(const StudyResults& study, Metric cost, const Clusters& clusters);

// Which pairs are compared: all, or of more than twenty solvers those with the best alone.
std::vector<std::pair<std::size_t, std::size_t>> compared_pairs(std::size_t solvers, std::size_t best);

// Ratios of expected running times; better: the first spends less. A sample without a success has an infinite running
// time and no ratio. Such a pair has no interval, and shares of success decide, each weighed by what the other spends:
// p2 c1 - p1 c2 has the sign of c1 / p1 - c2 / p2. The cost of who never succeeds is infinite.
std::vector<Finding> compare_costs(const StudyResults& study, Metric cost, const Clusters& clusters);

}  // namespace ikbench::inference
