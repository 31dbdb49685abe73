#include "analysis/statistics/mann_whitney.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "analysis/statistics/ranks.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

constexpr std::size_t exact_below = 50;

// The probabilities of U for n1 and n2 different values, by the sample that has the largest of all:
// (n1 + n2) P(n1, n2, u) = n1 P(n1 - 1, n2, u - n2) + n2 P(n1, n2 - 1, u).
std::vector<double> probabilities(std::size_t n1, std::size_t n2) {
  std::vector<std::vector<double>> by_first(n1 + 1);  // for n2 = 0 at first
  for (std::size_t a = 0; a <= n1; ++a) by_first[a].resize(a * n2 + 1);
  for (auto& distribution : by_first) distribution[0] = 1;
  for (std::size_t b = 1; b <= n2; ++b) {
    for (std::size_t a = 1; a <= n1; ++a) {
      const double in_first = static_cast<double>(a) / static_cast<double>(a + b);
      const std::vector<double>& before = by_first[a - 1];
      std::vector<double>& now = by_first[a];
      for (std::size_t u = 0; u < b; ++u) now[u] *= 1 - in_first;
      for (std::size_t u = b; u <= a * b; ++u) now[u] = in_first * before[u - b] + (1 - in_first) * now[u];
    }
  }
  return by_first[n1];
}

}  // namespace

double RankDistribution::two_sided(double statistic) const {
  if (probabilities.empty()) {
    return normal_two_sided(std::max(0.0, std::abs(statistic - mean) - 0.5) / standard_deviation);
  }
  const double nearer_zero = std::min(statistic, 2 * mean - statistic);
  double tail = 0;
  for (std::size_t i = 0; static_cast<double>(i) <= nearer_zero; ++i) tail += probabilities[i];
  return std::min(1.0, 2 * tail);
}

std::uint64_t RankDistribution::interval_rank(double level) const {
  if (probabilities.empty()) {
    const double rank = std::floor(mean - normal_critical(level) * standard_deviation + 0.5);
    return rank > 0 ? static_cast<std::uint64_t>(rank) : 0;
  }
  check_level(level);
  std::uint64_t rank = 0;
  for (double below = probabilities[0]; below <= (1 - level) / 2; below += probabilities[rank]) ++rank;
  return rank;
}

RankDistribution distribution_of_u(std::size_t n1, std::size_t n2, const Ranking& ranking) {
  const auto m = static_cast<double>(n1), n = static_cast<double>(n2);
  RankDistribution distribution{.mean = m * n / 2};
  if (ranking.ties.empty() && n1 < exact_below && n2 < exact_below) {
    distribution.probabilities = probabilities(n1, n2);
  } else {
    const double all = m + n;
    distribution.standard_deviation = std::sqrt(m * n / 12 * (all + 1 - ranking.tie_sum() / (all * (all - 1))));
  }
  return distribution;
}

Test mann_whitney(std::span<const double> first, std::span<const double> second) {
  Test test;
  if (first.empty() || second.empty()) {
    test.undefined = "a sample has no values";
    return test;
  }
  const Ranking ranking = midranks(first, second);
  test.undefined = ranking.all_equal() ? "all values are equal" : ranking.undefined;
  if (!ranking.undefined.empty()) return test;
  const auto n1 = static_cast<double>(first.size());
  double rank_sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) rank_sum += ranking.ranks[i];
  test.statistic = rank_sum - n1 * (n1 + 1) / 2;
  if (!test.undefined.empty()) return test;
  const RankDistribution distribution = distribution_of_u(first.size(), second.size(), ranking);
  test.p = distribution.two_sided(test.statistic);
  test.direction = sign_of(test.statistic - distribution.mean);
  return test;
}

namespace {

// For each value, the number of values of the other sample below it, equal ones half: its rank among all less its rank
// in its own.
std::vector<double> placements(std::span<const double> own, std::span<const double> among_all) {
  std::vector<double> result = midranks(own).ranks;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = among_all[i] - result[i];
  return result;
}

double chance_of_no_overlap(double n1, double n2) {
  return std::min(1.0, 2 * std::exp(std::lgamma(n1 + 1) + std::lgamma(n2 + 1) - std::lgamma(n1 + n2 + 1)));
}

}  // namespace

Test brunner_munzel(std::span<const double> first, std::span<const double> second) {
  Test test;
  if (first.size() < 2 || second.size() < 2) {
    test.undefined = "a sample has fewer than two values";
    return test;
  }
  const Ranking ranking = midranks(first, second);
  test.undefined = ranking.undefined;
  if (!test.undefined.empty()) return test;

  const auto n1 = static_cast<double>(first.size()), n2 = static_cast<double>(second.size());
  const std::span<const double> ranks(ranking.ranks);
  const GroupSummary one = summarise(placements(first, ranks.first(first.size())));
  const GroupSummary other = summarise(placements(second, ranks.last(second.size())));
  if (ranking.all_equal()) {
    test.undefined = "all values are equal";
    return test;
  }
  // The chance that a value of `first` is above one of `second`, equal ones half; and the two parts of its variance.
  const double above = one.mean / n2;
  const double v1 = one.std * one.std / (n1 * n2 * n2), v2 = other.std * other.std / (n2 * n1 * n1);
  if (v1 + v2 == 0) {
    test.statistic = std::copysign(std::numeric_limits<double>::infinity(), above - 0.5);
    test.p = chance_of_no_overlap(n1, n2);
    return test;
  }
  test.statistic = (above - 0.5) / std::sqrt(v1 + v2);
  test.df = (v1 + v2) * (v1 + v2) / (v1 * v1 / (n1 - 1) + v2 * v2 / (n2 - 1));
  test.p = 2 * t_upper_tail(std::abs(test.statistic), test.df);
  return test;
}

}  // namespace ikbench::statistics
