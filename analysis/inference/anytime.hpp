// Who is ahead before the end? Shares reached at parts of the budget of evaluations, which are readings of the runtime
// distributions after COCO (convergence.hpp), with intervals over clusters (clusters.hpp). What is reached at the end
// the plan's test judges.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/finding.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// Of one solver at one budget.
struct AtBudget {
  Estimate share = {};                      // reached within the budget
  std::optional<Finding> leader = {};       // the solver with the largest share, against this one; none of itself
  Relation relation = Relation::undefined;  // better: than all others; worse: than the leader
};

constexpr std::array<double, 4> budget_parts{0.01, 0.03, 0.1, 0.3};

struct Anytime {
  double budget = statistics::not_defined;  // evaluations: of the study, or without one of the longest solve
  bool is_of_study = false;
  std::array<std::vector<AtBudget>, budget_parts.size()> standings;  // of each solver
};

// Of solves that come to the tolerance or, without one, of pairs of a solve with a trace and a target error. Nothing
// where the study has neither, or fewer than two solvers have solves.
std::optional<Anytime> anytime(const StudyResults& study, const Clusters& clusters);

}  // namespace ikbench::inference
