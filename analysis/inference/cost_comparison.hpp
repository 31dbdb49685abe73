// What solvers spend until they come to the tolerance of a study, with intervals over clusters (clusters.hpp), and
// which of two spends less: expected running times, restricted means, and the probability of improvement (Agarwal,
// Schwarzer, Castro, Courville, Bellemare, NeurIPS (2021) 29304).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/statistics/running_time.hpp"
#include "analysis/statistics/survival.hpp"

namespace ikbench::inference {

// A mean cost and the same of every replicate; no replicates where there are too few clusters.
struct MeanCost {
  double estimate = statistics::not_defined;
  std::vector<double> replicates;
};

struct SolverCost {
  statistics::RunningTime time;
  statistics::SurvivalCurve curve;
  MeanCost expected;    // running time; infinite in a replicate in which no solve succeeds
  MeanCost restricted;  // to the horizon
};

struct Costs {
  double horizon = statistics::not_defined;  // the largest cost to which the curves of all solvers are known
  std::vector<SolverCost> solvers;           // in the order of the study's
};
Costs costs_of(const StudyResults& study, Cost cost, const Clusters& clusters);

// Which pairs are compared: all, or of more than twenty solvers those with the best alone.
std::vector<std::pair<std::size_t, std::size_t>> compared_pairs(std::size_t solvers, std::size_t best);

// A number of two solvers, and an interval that holds for all pairs together.
struct Compared {
  double value = statistics::not_defined;
  statistics::Interval interval = {};
};

struct CostPair {
  std::size_t first = 0;
  std::size_t second = 0;
  Compared expected;  // ratios: first / second
  Compared restricted;
  Compared improvement;  // P(first < second) at a target, ties half; solves that do not come to the tolerance tie
  // better: the first spends less. By the running times, or where they have no interval by the restricted means;
  // undecided where the two contradict each other, or the runs of both solvers are copies of one.
  Relation relation = Relation::undecided;
};
std::vector<CostPair> compare_costs(const StudyResults& study, Cost cost, const Clusters& clusters);

// first / second, with an interval of its own; the standard error is that of its logarithm, not defined where a
// replicate has no ratio.
struct CostRatio {
  double value = statistics::not_defined;
  statistics::Interval interval = {};
  double standard_error_of_log = statistics::not_defined;
};
CostRatio ratio_of(const MeanCost& first, const MeanCost& second, const Clusters& clusters);

}  // namespace ikbench::inference
