// Computes what solvers spend until a solve succeeds, by expected running times, and who is ahead before the end, by
// shares of targets reached within parts of the evaluation budget. Both are estimands with intervals over clusters
// (clusters.hpp). The plan's test judges the final results.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "analysis/inference/clusters.hpp"

namespace ikbench::inference {

// The cost of reaching a tolerance if some trials never do: expected running time (Hansen, Auger, Ros, Finck, Posik,
// GECCO companion (2010) 1689).
// Sums over trials, or over a bootstrap sample of them.
struct RunningTime {
  double trials = 0;
  double successes = 0;
  double spent = 0;  // in evaluations or seconds, until a trial reached the tolerance or was given up (censored)

  void add(double cost, bool is_success) {
    ++trials;
    successes += is_success ? 1 : 0;
    spent += cost;
  }
  // Infinite without a success, not defined without trials.
  double expected() const {
    if (trials == 0) return statistics::not_defined;
    return successes > 0 ? spent / successes : std::numeric_limits<double>::infinity();
  }
};

struct SolverCost {
  RunningTime time = {};
  std::vector<RunningTime> replicates = {};  // empty if there are too few clusters
  std::string undefined = {};                // the reason if there is no running time

  Estimate expected(const Clusters& clusters) const;  // expected running time
};
// Returns the costs in the order of the study's solvers. A solve that is not ok is given up at its cost.
std::vector<SolverCost> costs_of(const StudyResults& study, Metric cost, const Clusters& clusters);

// Ratios of expected running times; better: the first spends less. A sample without a success has an infinite running
// time and no ratio. Such a pair has no interval, and shares of success decide, each weighed by what the other spends:
// p2 c1 - p1 c2 has the sign of c1 / p1 - c2 / p2. A solver that never succeeds has an infinite cost.
std::vector<Finding> compare_costs(const StudyResults& study, Metric cost, const Clusters& clusters);

// A solver's result at one budget.
struct AtBudget {
  Estimate share = {};  // share reached within the budget
  // The solver with the largest share compared with this one; nullopt for the leader itself.
  std::optional<Finding> leader = {};
  Relation relation = Relation::undefined;  // better: than all others; worse: than the leader
};

constexpr std::array<double, 4> budget_parts{0.01, 0.03, 0.1, 0.3};

struct Anytime {
  double budget = statistics::not_defined;  // [evaluations]: the study's, or else those of the longest solve
  bool is_of_study = false;
  std::array<std::vector<AtBudget>, budget_parts.size()> standings = {};  // by budget and solver
};

// Counts solves that reach the tolerance or, without one, pairs of a solve with a trace and a target error
// (convergence.hpp). nullopt if the study has neither, or fewer than two solvers have solves.
std::optional<Anytime> anytime(const StudyResults& study, const Clusters& clusters);

}  // namespace ikbench::inference
