#include "analysis/inference/anytime.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/inference/convergence.hpp"
#include "analysis/inference/cost_comparison.hpp"
#include "analysis/inference/study_facts.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// What of a solver is to be reached: each value the evaluations that it took.
ClusteredValues evaluations_to_reach(const Solves& solves, const StudyResults& study, const Clusters& clusters) {
  const Tolerance within = tolerance(study);
  ClusteredValues result;
  for (const Solve* solve : solves) {
    std::vector<double> costs;
    if (std::isfinite(within.cm)) {
      costs.push_back(reaches(*solve, within) ? total_cost(study, *solve, Cost::evaluations) : censored);
    } else if (has_trace(*solve) && !study.facts.pose) {
      costs = costs_to_targets(study, *solve, target_errors_cm(study), Cost::evaluations);
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
  for (const Solve& solve : study.solves) largest = std::max(largest, total_cost(study, solve, Cost::evaluations));
  return largest;
}

// The differences leader - other of every pair that is compared, at every budget.
class RunDifferences {
 public:
  void add(const std::vector<SharesOfSolver>& solvers, std::size_t budget, std::size_t best) {
    for (const auto& [first, second] : compared_pairs(solvers.size(), best)) {
      if (!solvers[first].has_values || !solvers[second].has_values) continue;
      index_[{budget, first, second}] = family_.estimates.size();
      family_.estimates.push_back(solvers[first].shares[budget] - solvers[second].shares[budget]);
      std::vector<double>& replicates = family_.replicates.emplace_back();
      for (std::size_t b = 0; b < solvers[first].replicates.size(); ++b) {
        replicates.push_back(solvers[first].replicates[b][budget] - solvers[second].replicates[b][budget]);
      }
    }
  }
  void judge(std::size_t clusters, double level) {
    family_.clusters = clusters;
    intervals_ = simultaneous_intervals(family_, level);
  }
  Interval of(std::size_t budget, std::size_t leader, std::size_t other) const {
    auto [low, high] = intervals_[index_.at({budget, std::min(leader, other), std::max(leader, other)})];
    if (leader > other) std::tie(low, high) = std::pair(-high, -low);
    return {std::clamp(low, -1.0, 1.0), std::clamp(high, -1.0, 1.0)};
  }

 private:
  Family family_;
  std::map<std::array<std::size_t, 3>, std::size_t> index_;
  std::vector<Interval> intervals_;
};

void place(std::vector<AtBudget>& standings, std::size_t leader) {
  bool is_ahead = true;
  for (std::size_t i = 0; i < standings.size(); ++i) {
    if (i == leader || std::isnan(standings[i].share)) continue;
    const bool is_behind = standings[i].behind_interval.low > 0;
    if (is_behind) standings[i].relation = Relation::worse;
    is_ahead &= is_behind;
  }
  if (is_ahead) standings[leader].relation = Relation::better;
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
  RunDifferences differences;
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      if (!(solvers[i].shares[k] <= solvers[leaders[k]].shares[k]) && solvers[i].has_values) leaders[k] = i;
    }
    differences.add(solvers, k, leaders[k]);
  }
  differences.judge(clusters.drawn_at_once(), 1 - study.plan.significance);
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    const std::size_t leader = leaders[k];
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      AtBudget& standing = result.standings[k].emplace_back();
      if (!solvers[i].has_values) continue;
      standing.share = solvers[i].shares[k];
      standing.share_interval = clusters.interval(column(solvers[i].replicates, k));
      standing.behind = solvers[leader].shares[k] - standing.share;
      if (i != leader) standing.behind_interval = differences.of(k, leader, i);
    }
    place(result.standings[k], leader);
  }
  return result;
}

}  // namespace ikbench::inference
