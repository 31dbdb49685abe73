// Who is ahead at a tenth of the budget, and who at the end? Shares reached at set budgets of evaluations, which are
// readings of the runtime distributions after COCO (convergence.hpp), with intervals over clusters (clusters.hpp).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/relation.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

enum class Position { ahead, behind, open };

// Of one solver at one budget.
struct AtBudget {
  double share = statistics::not_defined;  // reached within the budget
  statistics::Interval share_interval = {};
  double behind = statistics::not_defined;    // the largest share of all solvers, less this one
  statistics::Interval behind_interval = {};  // with those of all pairs and budgets together
  // ahead: above all others; behind: below the largest; open: neither is shown.
  Relation relation = Relation::undecided;
};

constexpr std::array<double, 5> budget_parts{0.01, 0.03, 0.1, 0.3, 1};

struct Anytime {
  double budget = statistics::not_defined;  // evaluations: of the study, or without one of the longest solve
  bool is_of_study = false;
  std::array<std::vector<AtBudget>, budget_parts.size()> standings;  // of each solver
};

// Of solves that come to the tolerance or, without one, of pairs of a solve with a trace and a target error. Nothing
// where the study has neither, or fewer than two solvers have solves.
std::optional<Anytime> anytime(const StudyResults& study, const Clusters& clusters);

}  // namespace ikbench::inference
