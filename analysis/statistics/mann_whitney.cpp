#include "analysis/statistics/mann_whitney.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

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

MannWhitney mann_whitney(std::span<const double> first, std::span<const double> second) {
  MannWhitney test;
  if (first.empty() || second.empty()) {
    test.undefined = "a sample has no values";
    return test;
  }
  std::vector<double> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  const Ranking ranking = midranks(all);
  test.undefined = ranking.undefined;
  if (!test.undefined.empty()) return test;

  const auto n1 = static_cast<double>(first.size());
  double rank_sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) rank_sum += ranking.ranks[i];
  test.U = rank_sum - n1 * (n1 + 1) / 2;
  if (ranking.ties.size() == 1 && ranking.ties.front() == all.size()) {
    test.undefined = "all values are equal";
    return test;
  }
  const RankDistribution distribution = distribution_of_u(first.size(), second.size(), ranking);
  test.p = distribution.two_sided(test.U);
  test.direction = distribution.direction(test.U);
  test.method = distribution.method();
  return test;
}

}  // namespace ikbench::statistics
