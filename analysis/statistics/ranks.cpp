#include "analysis/statistics/ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

double Ranking::tie_sum() const {
  double sum = 0;
  for (const std::size_t tie : ties) {
    const auto t = static_cast<double>(tie);
    sum += t * t * t - t;
  }
  return sum;
}

Ranking midranks(std::span<const double> values) {
  Ranking ranking;
  if (std::ranges::any_of(values, [](double value) { return std::isnan(value); })) {
    ranking.undefined = "a value is not a number and has no rank";
    return ranking;
  }
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });  // merge sort: fast if sorted
  ranking.ranks.resize(values.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    const double shared = static_cast<double>(first + 1 + end) / 2;  // the mean of ranks first + 1 to end
    for (std::size_t i = first; i < end; ++i) ranking.ranks[order[i]] = shared;
    if (end - first > 1) ranking.ties.push_back(end - first);
  }
  return ranking;
}

Ranking midranks(std::span<const double> first, std::span<const double> second) {
  std::vector<double> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  return midranks(all);
}

std::vector<double> pooled(std::span<const std::vector<double>> groups) {
  std::vector<double> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

RankTest kruskal_wallis(std::span<const std::vector<double>> groups) {
  RankTest test;
  test.undefined = too_few_groups(groups.size());
  for (std::size_t i = 0; i < groups.size() && test.undefined.empty(); ++i) {
    if (groups[i].empty()) test.undefined = {i, "{} has no values"};
  }
  if (!test.undefined.empty()) return test;
  const Ranking ranking = midranks(pooled(groups));
  test.undefined = ranking.all_equal() ? "all values are equal" : ranking.undefined;
  if (!ranking.undefined.empty()) return test;
  const auto n = static_cast<double>(ranking.ranks.size());
  auto rank = ranking.ranks.begin();
  double between = 0;
  for (const auto& group : groups) {
    double sum = 0;
    for (std::size_t i = 0; i < group.size(); ++i) sum += *rank++;
    test.mean_ranks.push_back(sum / static_cast<double>(group.size()));
    const double deviation = test.mean_ranks.back() - (n + 1) / 2;
    between += static_cast<double>(group.size()) * deviation * deviation;
  }
  if (!test.undefined.empty()) return test;
  test.statistic = between / (n * (n + 1) / 12 - ranking.tie_sum() / (12 * (n - 1)));  // by the variance of the ranks
  test.df = static_cast<double>(groups.size() - 1);
  test.p = chi_squared_upper_tail(test.statistic, test.df);
  test.effect = test.statistic / (n - 1);
  return test;
}

namespace {

constexpr double rounding_of_w = 1e-10;  // of W, which is built from sums of ranks

// The chance that all blocks agree with the first: each of the other blocks - 1 takes one of k! / prod t! orders.
double chance_of_agreement(const RankTest& test, double blocks) {
  double log_ways = std::lgamma(static_cast<double>(test.mean_ranks.size()) + 1);
  for (const std::size_t tie : midranks(test.mean_ranks).ties) log_ways -= std::lgamma(static_cast<double>(tie) + 1);
  return std::exp(-log_ways * (blocks - 1));
}

}  // namespace

RankTest friedman(std::span<const std::vector<double>> groups) {
  RankTest test;
  test.mean_ranks.assign(groups.size(), not_defined);
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
  for (std::size_t i = 0; i < groups.size(); ++i) test.mean_ranks[i] = rank_sums[i] / n;
  if (test.undefined.empty() && tie_sum >= n * (k * k * k - k)) {
    test.undefined = "in every block all values are equal";
  }
  if (!test.undefined.empty()) return test;
  double between = 0;
  for (const double rank : test.mean_ranks) between += (rank - (k + 1) / 2) * (rank - (k + 1) / 2) / (k - 1);
  // By the mean over blocks of the variance of a block's ranks.
  test.effect = std::min(1.0, between / (k * (k + 1) / 12 - tie_sum / (12 * n * (k - 1))));
  test.df = k - 1;
  test.df_within = (k - 1) * (n - 1);
  if (test.effect >= 1 - rounding_of_w) {
    test.statistic = std::numeric_limits<double>::infinity();
    test.p = chance_of_agreement(test, n);  // Conover, Practical Nonparametric Statistics (1999), section 5.8
  } else {
    test.statistic = (n - 1) * test.effect / (1 - test.effect);
    test.p = f_upper_tail(test.statistic, test.df, test.df_within);
  }
  return test;
}

double critical_difference(double q_alpha, std::size_t groups, std::size_t blocks) {
  const auto k = static_cast<double>(groups);
  return groups < 2 || blocks == 0 ? not_defined : q_alpha * std::sqrt(k * (k + 1) / (6 * static_cast<double>(blocks)));
}

Test sign_test(std::span<const double> first, std::span<const double> second) {
  Test test;
  int above = 0, below = 0;
  if (first.size() != second.size()) {
    test.undefined = fmt::format("{} and {} values are not pairs", first.size(), second.size());
    return test;
  }
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double difference = first[i] == second[i] ? 0 : first[i] - second[i];
    if (std::isnan(difference)) test.undefined = "a value is not a number";
    const double size = std::max(std::abs(first[i]), std::abs(second[i]));
    const int sign = sign_of(std::isfinite(difference) ? without_rounding(difference, size) : difference);
    above += sign > 0 ? 1 : 0;
    below += sign < 0 ? 1 : 0;
  }
  if (first.empty()) test.undefined = "there are no differences";
  if (test.undefined.empty() && above + below == 0) test.undefined = "all differences are zero";
  if (!test.undefined.empty()) return test;
  test.p = mcnemar_exact({.first_only = above, .second_only = below});
  test.direction = sign_of(above - below);
  return test;
}

}  // namespace ikbench::statistics
