#include "analysis/statistics/friedman.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/statistics/anova.hpp"

namespace ikbench::statistics {
namespace {

constexpr double rounding_of_w = 1e-10;  // of W, which is built from sums of ranks

// The chance that all blocks agree with the first: each of the other blocks - 1 takes one of k! / prod t! orders.
double chance_of_agreement(const Friedman& test, double blocks) {
  double log_ways = std::lgamma(static_cast<double>(test.average_ranks.size()) + 1);
  for (const std::size_t tie : midranks(test.average_ranks).ties) log_ways -= std::lgamma(static_cast<double>(tie) + 1);
  return std::exp(-log_ways * (blocks - 1));
}

}  // namespace

Friedman friedman(std::span<const std::vector<double>> groups) {
  Friedman test;
  test.average_ranks.assign(groups.size(), not_defined);
  for (std::size_t i = 1; i < groups.size(); ++i) {
    if (groups[i].size() == groups[0].size()) continue;
    test.undefined = {i, fmt::format("{{}} has {} values, and another group has {}; each needs one a block",
                                     groups[i].size(), groups[0].size())};
    return test;
  }
  const std::size_t blocks = groups.empty() ? 0 : groups[0].size();
  test.undefined = too_few_groups(groups.size());
  if (test.undefined.empty() && blocks < 2) {
    test.undefined = fmt::format("{}; two or more are needed", blocks == 0 ? "no block" : "one block");
  }
  if (blocks == 0) return test;
  const auto k = static_cast<double>(groups.size()), n = static_cast<double>(blocks);
  std::vector<double> rank_sums(groups.size(), 0.0), block(groups.size());
  double tie_sum = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t i = 0; i < groups.size(); ++i) block[i] = groups[i][b];
    const Ranking ranking = midranks(block);
    if (!ranking.undefined.empty()) {
      test.undefined = fmt::format("block {}: {}", b + 1, ranking.undefined);
      return test;
    }
    for (std::size_t i = 0; i < groups.size(); ++i) rank_sums[i] += ranking.ranks[i];
    tie_sum += ranking.tie_sum();
  }
  for (std::size_t i = 0; i < groups.size(); ++i) test.average_ranks[i] = rank_sums[i] / n;
  if (test.undefined.empty() && tie_sum >= n * (k * k * k - k)) {
    test.undefined = "in every block all values are equal";
  }
  if (!test.undefined.empty()) return test;
  double between = 0;
  for (const double rank : test.average_ranks) between += (rank - (k + 1) / 2) * (rank - (k + 1) / 2) / (k - 1);
  // By the mean over blocks of the variance of a block's ranks.
  test.kendall_w = std::min(1.0, between / (k * (k + 1) / 12 - tie_sum / (12 * n * (k - 1))));
  test.df = k - 1;
  test.df_within = (k - 1) * (n - 1);
  if (test.kendall_w >= 1 - rounding_of_w) {
    test.statistic = std::numeric_limits<double>::infinity();
    test.p = chance_of_agreement(test, n);  // Conover, Practical Nonparametric Statistics (1999), section 5.8
  } else {
    test.statistic = (n - 1) * test.kendall_w / (1 - test.kendall_w);
    test.p = f_upper_tail(test.statistic, test.df, test.df_within);
  }
  return test;
}

double critical_difference(double q_alpha, std::size_t groups, std::size_t blocks) {
  const auto k = static_cast<double>(groups);
  return groups < 2 || blocks == 0 ? not_defined : q_alpha * std::sqrt(k * (k + 1) / (6 * static_cast<double>(blocks)));
}

}  // namespace ikbench::statistics
