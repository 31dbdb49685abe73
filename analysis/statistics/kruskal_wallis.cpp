#include "analysis/statistics/kruskal_wallis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

KruskalWallis kruskal_wallis(std::span<const std::vector<double>> groups) {
  KruskalWallis test;
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
  test.epsilon_squared = test.statistic / (n - 1);
  return test;
}

}  // namespace ikbench::statistics
