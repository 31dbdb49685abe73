#include "analysis/inference/costs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <utility>

#include "analysis/inference/convergence.hpp"
#include "analysis/inference/study_facts.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// A number, and that of every replicate.
struct Replicated {
  double value = not_defined;
  std::vector<double> replicates = {};
};

// Sums over the clusters that each replicate has drawn, from sums within clusters.
std::vector<RunningTime> replicates_of(const std::vector<RunningTime>& sums, const Clusters& clusters) {
  std::vector<RunningTime> result;
  for (const std::vector<double>& drawn : clusters.replicates()) {
    RunningTime& all = result.emplace_back();
    for (std::size_t c = 0; c < drawn.size(); ++c) {
      all.trials += drawn[c] * sums[c].trials;
      all.successes += drawn[c] * sums[c].successes;
      all.spent += drawn[c] * sums[c].spent;
    }
  }
  return result;
}

// Compares two running times, and those of every replicate.
template <class Compare>
Replicated compared(const SolverCost& first, const SolverCost& second, Compare compare) {
  Replicated result{.value = compare(first.time, second.time)};
  for (std::size_t b = 0; b < std::min(first.replicates.size(), second.replicates.size()); ++b) {
    result.replicates.push_back(compare(first.replicates[b], second.replicates[b]));
  }
  return result;
}

Replicated log_ratio(const SolverCost& first, const SolverCost& second) {
  return compared(first, second, [](const RunningTime& one, const RunningTime& other) {
    return std::log(one.expected()) - std::log(other.expected());
  });
}

// Above 0 where the first costs more.
Replicated shares_of_success(const SolverCost& first, const SolverCost& second) {
  return compared(first, second, [&](const RunningTime& one, const RunningTime& other) {
    double by_first = one.spent / one.trials, by_second = other.spent / other.trials;
    if (first.time.successes == 0 || second.time.successes == 0) {  // an infinite cost outweighs any other
      by_first = first.time.successes == 0 ? 1 : 0;
      by_second = 1 - by_first;
    }
    return (by_first * other.successes / other.trials - by_second * one.successes / one.trials) /
           (by_first + by_second);
  });
}

std::string why_without_ratio(const SolverCost& first, const SolverCost& second, const Finding& found) {
  if (!first.undefined.empty()) return first.undefined;
  if (!second.undefined.empty()) return second.undefined;
  if (found.relation == Relation::undefined) return found.why;
  return first.time.successes + second.time.successes == 0 ? "neither solves anything" : "shares solved decide";
}

// The evaluations that a solver took to reach each target.
ClusteredValues evaluations_to_reach(const Solves& solves, const StudyResults& study, const Clusters& clusters) {
  const bool has_tolerance = std::isfinite(tolerance_cm(study));
  return clustered(solves, clusters, [&](const Solve& solve) -> std::vector<double> {
    if (has_tolerance) return {is_ok(solve) ? total_cost(study, solve, Metric::evaluations) : censored};
    if (!has_trace(solve) || study.facts.pose) return {};
    return costs_to_targets(study, solve, target_errors_cm(study), Metric::evaluations, iterations_of(study, solve));
  });
}

using SharesOfSolver = std::array<Replicated, budget_parts.size()>;  // not defined without values

bool has_values(const SharesOfSolver& solver) { return !std::isnan(solver.front().value); }

SharesOfSolver shares_of(const ClusteredValues& of, const Clusters& clusters, std::span<const double> budgets) {
  std::vector<std::vector<double>> replicates = resampled_shares(of, clusters, budgets);
  SharesOfSolver result;
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    const auto within = std::ranges::count_if(of.values, [&](double value) { return value <= budgets[k]; });
    result[k] = {static_cast<double>(within) / static_cast<double>(of.values.size()), std::move(replicates[k])};
  }
  return result;
}

std::vector<Finding> pairs_of_solvers(std::size_t solvers, std::size_t best) {
  return unjudged_pairs(solvers, solvers > most_groups_in_pairs ? std::optional(best) : std::nullopt);
}

using Leaders = std::array<std::size_t, budget_parts.size()>;

// The pairs of solvers at every budget, judged as one family.
std::array<std::vector<Finding>, budget_parts.size()> compare_shares(const std::vector<SharesOfSolver>& solvers,
                                                                     const Leaders& leaders, const Clusters& clusters) {
  std::vector<Finding> family;
  std::vector<std::size_t> budgets;  // of each pair
  std::vector<std::vector<double>> replicates;
  for (std::size_t k = 0; k < leaders.size(); ++k) {
    for (Finding& pair : pairs_of_solvers(solvers.size(), leaders[k])) {
      const SharesOfSolver &first = solvers[pair.first], &second = solvers[pair.second];
      if (!has_values(first) || !has_values(second)) continue;
      pair.estimate.value = first[k].value - second[k].value;
      std::ranges::transform(first[k].replicates, second[k].replicates, std::back_inserter(replicates.emplace_back()),
                             std::minus());
      family.push_back(std::move(pair));
      budgets.push_back(k);
    }
  }
  judge(family, replicates, Better::larger, clusters);
  std::array<std::vector<Finding>, budget_parts.size()> result;
  for (std::size_t i = 0; i < family.size(); ++i) {
    for (double* limit : {&family[i].estimate.low, &family[i].estimate.high}) *limit = std::clamp(*limit, -1.0, 1.0);
    result[budgets[i]].push_back(std::move(family[i]));
  }
  return result;
}

void place(std::vector<AtBudget>& standings, std::size_t leader) {
  Relation& of_leader = standings[leader].relation = Relation::better;
  for (AtBudget& standing : standings) {
    if (!standing.leader) continue;
    const Relation found = standing.leader->relation;
    standing.relation = reversed(found);
    of_leader = std::max(of_leader, found);  // the least that is known of any other
  }
}

}  // namespace

Estimate SolverCost::expected(const Clusters& clusters) const {
  std::vector<double> of_replicates;
  for (const RunningTime& replicate : replicates) of_replicates.push_back(replicate.expected());
  return clusters.estimate(time.expected(), std::move(of_replicates));
}

std::vector<SolverCost> costs_of(const StudyResults& study, Metric cost, const Clusters& clusters) {
  std::vector<SolverCost> result;
  for (const Solves& solves : solves_by_solver(study)) {
    SolverCost& solver = result.emplace_back();
    std::vector<RunningTime> sums(clusters.drawn_at_once());
    for (const Solve* solve : solves) {
      const double spent = total_cost(study, *solve, cost);
      solver.time.add(spent, is_ok(*solve));
      sums[clusters.of(*solve)].add(spent, is_ok(*solve));
    }
    if (solves.empty()) {
      solver.undefined = "there are no trials";
    } else if (!std::isfinite(solver.time.spent)) {
      solver.undefined = "a cost is not finite, or their sum is too large";
      solver.time = {};
    } else {
      solver.replicates = replicates_of(sums, clusters);
    }
  }
  return result;
}

std::vector<Finding> compare_costs(const StudyResults& study, Metric cost, const Clusters& clusters) {
  const std::vector<SolverCost> costs = costs_of(study, cost, clusters);
  const auto best = std::ranges::min_element(costs, {}, [](const SolverCost& solver) {
    const double expected = solver.time.expected();
    return std::isnan(expected) ? std::pair(true, 0.0) : std::pair(false, expected);
  });
  std::vector<Finding> found = pairs_of_solvers(costs.size(), static_cast<std::size_t>(best - costs.begin()));
  std::vector<std::vector<double>> replicates;
  for (Finding& pair : found) {
    const SolverCost &first = costs[pair.first], &second = costs[pair.second];
    Replicated number = log_ratio(first, second);
    pair.is_ratio = std::isfinite(number.value) && all_finite(number.replicates);
    if (!pair.is_ratio) number = shares_of_success(first, second);
    pair.estimate.value = number.value;
    replicates.push_back(std::move(number.replicates));
  }
  judge(found, replicates, Better::smaller, clusters);
  for (Finding& pair : found) {
    const SolverCost &first = costs[pair.first], &second = costs[pair.second];
    const auto limit = [&](double logarithm) { return pair.is_ratio ? std::exp(logarithm) : not_defined; };
    if (!pair.is_ratio) pair.why = why_without_ratio(first, second, pair);
    pair.estimate = {.value = first.time.expected() / second.time.expected(),
                     .low = limit(pair.estimate.low),
                     .high = limit(pair.estimate.high)};
    pair.is_ratio = true;
  }
  return found;
}

std::optional<Anytime> anytime(const StudyResults& study, const Clusters& clusters) {
  const double of_study = study.facts.stop.evaluations;
  Anytime result{.budget = of_study, .is_of_study = of_study > 0};
  if (!result.is_of_study) {
    result.budget = 0;
    for (const Solve& solve : study.solves)
      result.budget = std::max(result.budget, total_cost(study, solve, Metric::evaluations));
  }
  if (!(result.budget > 0)) return std::nullopt;
  std::array<double, budget_parts.size()> budgets = budget_parts;
  for (double& budget : budgets) budget *= result.budget;
  std::vector<SharesOfSolver> solvers;
  for (const Solves& solves : solves_by_solver(study))
    solvers.push_back(shares_of(evaluations_to_reach(solves, study, clusters), clusters, budgets));
  if (std::ranges::count_if(solvers, has_values) < 2) return std::nullopt;
  Leaders leaders{};
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    const auto share = [&](const SharesOfSolver& solver) { return has_values(solver) ? solver[k].value : -1; };
    leaders[k] = static_cast<std::size_t>(std::ranges::max_element(solvers, {}, share) - solvers.begin());
  }
  const auto found = compare_shares(solvers, leaders, clusters);
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      AtBudget& standing = result.standings[k].emplace_back();
      if (!has_values(solvers[i])) continue;
      standing.share = clusters.estimate(solvers[i][k].value, solvers[i][k].replicates);
      standing.leader = finding_of(found[k], leaders[k], i);
    }
    place(result.standings[k], leaders[k]);
  }
  return result;
}

}  // namespace ikbench::inference
