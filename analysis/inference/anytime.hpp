// Finds who is ahead before the end: shares of targets reached within parts of the evaluation budget, read from the
// runtime distributions after COCO (convergence.hpp), with intervals over clusters (clusters.hpp). The plan's test
// judges the final results.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/finding.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// A solver's result at one budget.
struct AtBudget {
  Estimate share = {};  // share reached within the budget
  std::optional<Finding> leader =
      {};  // the solver with the largest share compared with this one; nullopt for the leader itself
  Relation relation = Relation::undefined;  // better: than all others; worse: than the leader
};

constexpr std::array<double, 4> budget_parts{0.01, 0.03, 0.1, 0.3};

struct Anytime {
  double budget = statistics::not_defined;  // [evaluations]: the study's, or else those of the longest solve
  bool is_of_study = false;
  std::array<std::vector<AtBudget>, budget_parts.size()> standings;  // by budget and solver
};

// Counts solves that reach the tolerance or, without one, pairs of a solve with a trace and a target error. nullopt if
// the study has neither, or fewer than two solvers have solves.
std::optional<Anytime> anytime(const StudyResults& study, const Clusters& clusters);

}  // namespace ikbench::inference
