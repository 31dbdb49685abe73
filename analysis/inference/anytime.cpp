#include "analysis/inference/anytime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "analysis/inference/convergence.hpp"
#include "analysis/inference/cost_comparison.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// The evaluations that a solver took to reach each target.
ClusteredValues evaluations_to_reach(const Solves& solves, const StudyResults& study, const Clusters& clusters) {
  const bool has_tolerance = std::isfinite(tolerance_cm(study));
  ClusteredValues result;
  for (const Solve* solve : solves) {
    std::vector<double> costs;
    if (has_tolerance) {
      costs.push_back(is_ok(*solve) ? total_cost(study, *solve, Metric::evaluations) : censored);
    } else if (has_trace(*solve) && !study.facts.pose) {
      costs = costs_to_targets(study, *solve, target_errors_cm(study), Metric::evaluations);
    }
    for (const double cost : costs) {
      result.values.push_back(cost);
      result.clusters.push_back(clusters.of(*solve));
    }
  }
  return result;
}

struct SharesOfSolver {
  bool has_values = false;
  std::array<double, budget_parts.size()> shares{};
  std::vector<std::vector<double>> replicates;  // [replicate][budget]
};

std::vector<double> column(const std::vector<std::vector<double>>& replicates, std::size_t budget) {
  std::vector<double> result;
  for (const std::vector<double>& replicate : replicates) result.push_back(replicate[budget]);
  return result;
}

double budget_of(const StudyResults& study) {
  double largest = 0;
  for (const Solve& solve : study.solves) largest = std::max(largest, total_cost(study, solve, Metric::evaluations));
  return largest;
}

std::string quantity_at(std::size_t budget) {
  return fmt::format("share within {} of the budget", percent(budget_parts[budget]));
}

// The pairs of solvers compared at every budget.
std::vector<Finding> compare_shares(const StudyResults& study, const std::vector<SharesOfSolver>& solvers,
                                    std::span<const std::size_t> leaders, const Clusters& clusters) {
  std::vector<Finding> family;
  std::vector<std::vector<double>> replicates;
  for (std::size_t k = 0; k < leaders.size(); ++k) {
    for (const auto& [one, other] : compared_pairs(solvers.size(), leaders[k])) {
      const SharesOfSolver &first = solvers[one], &second = solvers[other];
      if (!first.has_values || !second.has_values) continue;
      family.push_back({.quantity = quantity_at(k),
                        .first = study.solvers[one],
                        .second = study.solvers[other],
                        .estimate = {.value = first.shares[k] - second.shares[k]}});
      std::vector<double>& differences = replicates.emplace_back();
      for (std::size_t b = 0; b < first.replicates.size(); ++b) {
        differences.push_back(first.replicates[b][k] - second.replicates[b][k]);
      }
    }
  }
  judge(family, replicates, Better::larger, clusters);
  for (Finding& finding : family) {
    finding.estimate.low = std::clamp(finding.estimate.low, -1.0, 1.0);
    finding.estimate.high = std::clamp(finding.estimate.high, -1.0, 1.0);
  }
  return family;
}

void place(std::vector<AtBudget>& standings, std::size_t leader) {
  Relation& of_leader = standings[leader].relation = Relation::better;
  for (AtBudget& standing : standings) {
    if (!standing.leader) continue;
    const Relation found = standing.leader->relation;
    standing.relation = reversed(found);
    if (found != Relation::better) of_leader = found;
  }
}

}  // namespace

std::optional<Anytime> anytime(const StudyResults& study, const Clusters& clusters) {
  const double of_study = study.facts.stop.evaluations;
  Anytime result{.budget = of_study > 0 ? of_study : budget_of(study), .is_of_study = of_study > 0, .standings = {}};
  if (!(result.budget > 0)) return std::nullopt;
  std::vector<double> budgets;
  for (const double part : budget_parts) budgets.push_back(part * result.budget);

  std::vector<SharesOfSolver> solvers;
  for (const Solves& solves : solves_by_solver(study)) {
    const ClusteredValues values = evaluations_to_reach(solves, study, clusters);
    SharesOfSolver& solver = solvers.emplace_back();
    solver.has_values = !values.values.empty();
    for (std::size_t k = 0; k < budgets.size(); ++k) {
      const auto within = std::ranges::count_if(values.values, [&](double value) { return value <= budgets[k]; });
      solver.shares[k] = static_cast<double>(within) / static_cast<double>(values.values.size());
    }
    solver.replicates = resampled_shares(values, clusters, budgets);
  }
  if (std::ranges::count_if(solvers, &SharesOfSolver::has_values) < 2) return std::nullopt;

  std::array<std::size_t, budget_parts.size()> leaders{};
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      if (!(solvers[i].shares[k] <= solvers[leaders[k]].shares[k]) && solvers[i].has_values) leaders[k] = i;
    }
  }
  const std::vector<Finding> found = compare_shares(study, solvers, leaders, clusters);
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      AtBudget& standing = result.standings[k].emplace_back();
      if (!solvers[i].has_values) continue;
      standing.share = clusters.estimate(solvers[i].shares[k], column(solvers[i].replicates, k));
      if (i == leaders[k]) continue;
      standing.leader = finding_of(found, quantity_at(k), study.solvers[leaders[k]], study.solvers[i]);
    }
    place(result.standings[k], leaders[k]);
  }
  return result;
}

}  // namespace ikbench::inference
