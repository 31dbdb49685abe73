#include "analysis/statistics/ranks.hpp"

#include <algorithm>
#include <numeric>

#include "analysis/statistics/anova.hpp"
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

}  // namespace ikbench::statistics
