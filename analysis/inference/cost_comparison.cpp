#include "analysis/inference/cost_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr std::size_t most_for_all_pairs = 20;

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

// A number that is above 0 where the first costs more, and that of every replicate.
struct ReplicatedNumber {
  double value = not_defined;
  std::vector<double> replicates = {};
};

class Pair {
 public:
  Pair(const SolverCost& first, const SolverCost& second) : first_(first), second_(second) {}

  ReplicatedNumber log_ratio() const {
    return by([](const RunningTime& first, const RunningTime& second) {
      return std::log(first.expected()) - std::log(second.expected());
    });
  }

  ReplicatedNumber shares_of_success() const {
    return by([&](const RunningTime& first, const RunningTime& second) {
      double by_first = first.spent / first.trials, by_second = second.spent / second.trials;
      if (first_.time.successes == 0 || second_.time.successes == 0) {  // an infinite cost outweighs any other
        by_first = first_.time.successes == 0 ? 1 : 0;
        by_second = 1 - by_first;
      }
      return (by_first * second.successes / second.trials - by_second * first.successes / first.trials) /
             (by_first + by_second);
    });
  }

  // A pair without a ratio has these.
  std::string why(const Finding& finding) const {
    if (!first_.undefined.empty()) return first_.undefined;
    if (!second_.undefined.empty()) return second_.undefined;
    if (finding.relation == Relation::undefined) return finding.why;
    return first_.time.successes + second_.time.successes == 0 ? "neither solves anything" : "shares solved decide";
  }

 private:
  template <class Of>
  ReplicatedNumber by(Of of) const {
    ReplicatedNumber result{.value = of(first_.time, second_.time)};
    for (std::size_t b = 0; b < std::min(first_.replicates.size(), second_.replicates.size()); ++b) {
      result.replicates.push_back(of(first_.replicates[b], second_.replicates[b]));
    }
    return result;
  }

  const SolverCost& first_;
  const SolverCost& second_;
};

bool is_finite(const ReplicatedNumber& compared) {
  return std::isfinite(compared.value) && all_finite(compared.replicates);
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
    }
    if (solver.undefined.empty()) solver.replicates = replicates_of(sums, clusters);
    if (!solver.undefined.empty()) solver.time = {};
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

std::vector<Finding> compare_costs(const StudyResults& study, Metric cost, const Clusters& clusters) {
  const std::vector<SolverCost> costs = costs_of(study, cost, clusters);
  std::size_t best = 0;
  for (std::size_t i = 1; i < costs.size(); ++i) {
    const double least = costs[best].time.expected();
    if (costs[i].time.expected() < least || std::isnan(least)) best = i;
  }
  const auto pairs = compared_pairs(costs.size(), best);
  std::vector<Finding> found;
  std::vector<std::vector<double>> replicates;
  std::vector<bool> has_ratio;
  for (const auto& [first, second] : pairs) {
    const Pair pair(costs[first], costs[second]);
    ReplicatedNumber compared = pair.log_ratio();
    has_ratio.push_back(is_finite(compared));
    if (!has_ratio.back()) compared = pair.shares_of_success();
    found.push_back({.quantity = fmt::format("expected {}", name_of(cost)),
                     .first = study.solvers[first],
                     .second = study.solvers[second],
                     .estimate = {.value = compared.value}});
    replicates.push_back(std::move(compared.replicates));
  }
  judge(found, replicates, Better::smaller, clusters);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const SolverCost &first = costs[pairs[i].first], &second = costs[pairs[i].second];
    auto& [value, low, high] = found[i].estimate;
    found[i].is_ratio = true;
    value = first.time.expected() / second.time.expected();
    low = has_ratio[i] ? std::exp(low) : not_defined;
    high = has_ratio[i] ? std::exp(high) : not_defined;
    if (!has_ratio[i]) found[i].why = Pair(first, second).why(found[i]);
  }
  return found;
}

}  // namespace ikbench::inference
