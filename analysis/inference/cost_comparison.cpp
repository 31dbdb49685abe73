#include "analysis/inference/cost_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/pairs.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr std::size_t most_for_all_pairs = 20;
constexpr double most_comparisons = 2e7;  // of two solves at the same target

double common_horizon(const std::vector<SolverCost>& solvers) {
  double known_by_all = censored, largest = 0;
  for (const SolverCost& solver : solvers) {
    const SurvivalCurve& curve = solver.curve;
    if (!curve.undefined.empty()) continue;
    const bool ends_at_zero = !curve.steps.empty() && curve.steps.back().survival == 0;
    if (!ends_at_zero) known_by_all = std::min(known_by_all, curve.last_cost);
    largest = std::max(largest, curve.last_cost);
  }
  return std::min(known_by_all, largest);
}

// By sums within clusters.
std::vector<double> expected_replicates(const std::vector<CensoredCost>& costs, const std::vector<std::size_t>& cluster,
                                        const Clusters& clusters) {
  std::vector<double> spent(clusters.drawn_at_once()), successes(clusters.drawn_at_once());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    spent[cluster[i]] += costs[i].spent;
    if (costs[i].reached) ++successes[cluster[i]];
  }
  std::vector<double> result;
  for (const std::vector<double>& drawn : clusters.replicates()) {
    double all_spent = 0, all_successes = 0;
    for (std::size_t c = 0; c < drawn.size(); ++c) {
      all_spent += drawn[c] * spent[c];
      all_successes += drawn[c] * successes[c];
    }
    result.push_back(all_successes > 0 ? all_spent / all_successes : censored);
  }
  return result;
}

// The logarithms of the ratios of two means, for simultaneous_intervals().
void add_to(Family& family, const MeanCost& first, const MeanCost& second) {
  family.estimates.push_back(std::log(first.estimate / second.estimate));
  std::vector<double>& logarithms = family.replicates.emplace_back();
  for (std::size_t b = 0; b < std::min(first.replicates.size(), second.replicates.size()); ++b) {
    logarithms.push_back(std::log(first.replicates[b] / second.replicates[b]));
  }
}

// Of two clusters: how often a solve of the first solver is better than one of the second at the same target, and how
// often it is held against one. Every target counts the same.
struct Meeting {
  double better = 0;
  double held = 0;
};
using Meetings = std::map<std::pair<std::size_t, std::size_t>, Meeting>;

struct CostAtTarget {
  double cost;
  std::size_t cluster;
};
using AtTargets = std::vector<std::vector<CostAtTarget>>;

Meetings meetings_of(const AtTargets& first, const AtTargets& second) {
  double comparisons = 0;
  for (std::size_t t = 0; t < first.size(); ++t) {
    comparisons += static_cast<double>(first[t].size()) * static_cast<double>(second[t].size());
  }
  Meetings meetings;
  if (comparisons > most_comparisons) return meetings;
  for (std::size_t t = 0; t < first.size(); ++t) {
    const double weight = 1 / (static_cast<double>(first[t].size()) * static_cast<double>(second[t].size()));
    for (const CostAtTarget& a : first[t]) {
      for (const CostAtTarget& b : second[t]) {
        Meeting& meeting = meetings[{a.cluster, b.cluster}];
        meeting.better += weight * (a.cost < b.cost ? 1 : a.cost == b.cost ? 0.5 : 0);
        meeting.held += weight;
      }
    }
  }
  return meetings;
}

double improvement_of(const Meetings& meetings, const std::vector<double>& drawn) {
  double better = 0, held = 0;
  for (const auto& [clusters, meeting] : meetings) {
    const auto& [a, b] = clusters;
    const double times = a == b ? drawn[a] : drawn[a] * drawn[b];
    better += times * meeting.better;
    held += times * meeting.held;
  }
  return better / held;
}

std::vector<AtTargets> costs_at_targets(const StudyResults& study, Cost cost, const Clusters& clusters) {
  const std::vector<std::uint32_t> targets = target_numbers(study);
  const std::size_t count = targets.empty() ? 0 : std::size_t{std::ranges::max(targets)} + 1;
  const Tolerance within = tolerance(study);
  std::vector<AtTargets> result;
  for (const Solves& solves : solves_by_solver(study)) {
    AtTargets& at = result.emplace_back(count);
    for (const Solve* solve : solves) {
      at[targets[static_cast<std::size_t>(solve - study.solves.data())]].push_back(
          {reaches(*solve, within) ? total_cost(study, *solve, cost) : censored, clusters.of(*solve)});
    }
  }
  return result;
}

// Above or below 0, or neither. An interval without width is a difference that every cluster has.
int side_of(const Interval& interval) { return interval.low > 0 ? 1 : interval.high < 0 ? -1 : 0; }

// Whether the clusters are runs, and those of both solvers copies of one, which show no variation.
bool are_copies(const StudyResults& study, const std::pair<std::size_t, std::size_t>& pair, const Clusters& clusters) {
  return clusters.noun() == "runs" && repeats_itself(study, study.solvers[pair.first]) &&
         repeats_itself(study, study.solvers[pair.second]);
}

Compared of_logarithm(double logarithm, const Interval& interval) {
  return {std::exp(logarithm), {std::exp(interval.low), std::exp(interval.high)}};
}

}  // namespace

Costs costs_of(const StudyResults& study, Cost cost, const Clusters& clusters) {
  Costs result;
  const std::vector<std::vector<CensoredCost>> groups = censored_costs(study, cost);
  for (const auto& group : groups) {
    result.solvers.push_back(
        {.time = running_time(group), .curve = kaplan_meier(group), .expected = {}, .restricted = {}});
  }
  result.horizon = common_horizon(result.solvers);
  const std::vector<Solves> solves = solves_by_solver(study);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    SolverCost& solver = result.solvers[i];
    solver.expected.estimate = solver.time.expected;
    solver.restricted.estimate = restricted_mean(solver.curve, result.horizon).mean;
    if (!solver.curve.undefined.empty()) continue;
    const std::vector<std::size_t> cluster = clusters.of(solves[i]);
    solver.expected.replicates = expected_replicates(groups[i], cluster, clusters);
    const ClusteredSurvival survival(groups[i], cluster);
    for (const std::vector<double>& drawn : clusters.replicates()) {
      solver.restricted.replicates.push_back(survival.restricted_mean(result.horizon, drawn));
    }
  }
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> compared_pairs(std::size_t solvers, std::size_t best) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t first = 0; first < solvers; ++first) {
    for (std::size_t second = first + 1; second < solvers; ++second) {
      if (solvers <= most_for_all_pairs || first == best || second == best) pairs.emplace_back(first, second);
    }
  }
  return pairs;
}

std::vector<CostPair> compare_costs(const StudyResults& study, Cost cost, const Clusters& clusters) {
  const Costs costs = costs_of(study, cost, clusters);
  std::size_t best = 0;
  for (std::size_t i = 1; i < costs.solvers.size(); ++i) {
    if (!(costs.solvers[best].expected.estimate <= costs.solvers[i].expected.estimate)) best = i;
  }
  const std::vector<AtTargets> at_targets = costs_at_targets(study, cost, clusters);
  const auto pairs = compared_pairs(costs.solvers.size(), best);
  const std::size_t drawn = clusters.drawn_at_once();
  Family expected{.estimates = {}, .replicates = {}, .clusters = drawn}, restricted = expected, improvement = expected;
  for (const auto& [first, second] : pairs) {
    add_to(expected, costs.solvers[first].expected, costs.solvers[second].expected);
    add_to(restricted, costs.solvers[first].restricted, costs.solvers[second].restricted);
    const Meetings meetings = meetings_of(at_targets[first], at_targets[second]);
    improvement.estimates.push_back(improvement_of(meetings, std::vector<double>(drawn, 1.0)));
    std::vector<double>& replicates = improvement.replicates.emplace_back();
    for (const std::vector<double>& weights : clusters.replicates()) {
      replicates.push_back(improvement_of(meetings, weights));
    }
  }
  const double level = 1 - study.plan.significance;
  const std::vector<Interval> of_expected = simultaneous_intervals(expected, level);
  const std::vector<Interval> of_restricted = simultaneous_intervals(restricted, level);
  const std::vector<Interval> of_improvement = simultaneous_intervals(improvement, level);
  std::vector<CostPair> result;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const int by_restricted = side_of(of_restricted[i]);
    const int side = std::isnan(of_expected[i].low) ? by_restricted : side_of(of_expected[i]);
    result.push_back(
        {.first = pairs[i].first,
         .second = pairs[i].second,
         .expected = of_logarithm(expected.estimates[i], of_expected[i]),
         .restricted = of_logarithm(restricted.estimates[i], of_restricted[i]),
         .improvement = {improvement.estimates[i],
                         {std::clamp(of_improvement[i].low, 0.0, 1.0), std::clamp(of_improvement[i].high, 0.0, 1.0)}},
         .relation = side * by_restricted < 0 || side == 0 || are_copies(study, pairs[i], clusters)
                         ? Relation::undecided
                     : side < 0 ? Relation::better
                                : Relation::worse});
  }
  return result;
}

CostRatio ratio_of(const MeanCost& first, const MeanCost& second, const Clusters& clusters) {
  std::vector<double> ratios, logarithms;
  for (std::size_t b = 0; b < std::min(first.replicates.size(), second.replicates.size()); ++b) {
    ratios.push_back(first.replicates[b] / second.replicates[b]);
    logarithms.push_back(std::log(ratios.back()));
  }
  return {.value = first.estimate / second.estimate,
          .interval = clusters.interval(std::move(ratios)),
          .standard_error_of_log = standard_deviation(logarithms)};
}

}  // namespace ikbench::inference
