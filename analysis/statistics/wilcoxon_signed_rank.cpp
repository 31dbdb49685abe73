#include "analysis/statistics/wilcoxon_signed_rank.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/statistics/ranks.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::statistics {
namespace {

constexpr int exact_pairs_below = 50;

// Of 2 V, a whole number also where equal sizes share a rank: each rank is in the sum or not, with equal chances.
std::vector<double> probabilities_of_twice(const std::vector<double>& ranks) {
  std::vector<double> distribution{1};
  for (const double rank : ranks) {
    const auto twice = static_cast<std::size_t>(std::lround(2 * rank));
    std::vector<double> next(distribution.size() + twice, 0.0);
    for (std::size_t v = 0; v < distribution.size(); ++v) {
      next[v] += distribution[v] / 2;
      next[v + twice] += distribution[v] / 2;
    }
    distribution = std::move(next);
  }
  return distribution;
}

}  // namespace

WilcoxonSignedRank wilcoxon_signed_rank(std::span<const double> differences) {
  WilcoxonSignedRank test;
  std::vector<double> sizes;
  std::vector<bool> positive;
  for (const double difference : differences) {
    if (difference == 0) {
      ++test.zeros;
      continue;
    }
    sizes.push_back(std::abs(difference));
    positive.push_back(difference > 0);
  }
  test.n = static_cast<int>(sizes.size());
  const Ranking ranking = midranks(sizes);
  test.undefined = ranking.undefined;
  if (sizes.empty()) test.undefined = differences.empty() ? "there are no differences" : "all differences are zero";
  if (!test.undefined.empty()) return test;

  test.V = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (positive[i]) test.V += ranking.ranks[i];
  }
  const auto n = static_cast<double>(test.n);
  RankDistribution distribution{.mean = n * (n + 1) / 4};
  test.direction = distribution.direction(test.V);
  if (test.n < exact_pairs_below) {
    distribution = {.probabilities = probabilities_of_twice(ranking.ranks), .mean = 2 * distribution.mean};
    test.p = distribution.two_sided(2 * test.V);
  } else {
    distribution.standard_deviation = std::sqrt(n * (n + 1) * (2 * n + 1) / 24 - ranking.tie_sum() / 48);
    test.p = distribution.two_sided(test.V);
  }
  test.method = distribution.method();
  return test;
}

WilcoxonSignedRank wilcoxon_signed_rank(std::span<const double> first, std::span<const double> second) {
  if (first.size() != second.size()) {
    return {.undefined = fmt::format("{} and {} values are not pairs", first.size(), second.size())};
  }
  std::vector<double> differences = differences_without_rounding(first, second);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == second[i]) differences[i] = 0;
  }
  return wilcoxon_signed_rank(differences);
}

}  // namespace ikbench::statistics
