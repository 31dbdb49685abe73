#include "analysis/statistics/kruskal_wallis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

struct RankedGroups {
  double n = 0;
  std::vector<double> mean_ranks;
  double variance = not_defined;  // of the ranks, ties counted: (n + 1) n / 12 - sum (t^3 - t) / (12 (n - 1))
  std::string undefined;
};

RankedGroups rank_groups(std::span<const std::vector<double>> groups) {
  RankedGroups ranked;
  if (groups.size() < 2) {
    ranked.undefined = fmt::format("{} to compare; two or more are needed", groups.empty() ? "no group" : "one group");
    return ranked;
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].empty()) ranked.undefined = fmt::format("group {} has no values", i + 1);
    if (!ranked.undefined.empty()) return ranked;
  }
  const Ranking ranking = midranks(pooled(groups));
  ranked.undefined = ranking.undefined;
  if (!ranked.undefined.empty()) return ranked;
  ranked.n = static_cast<double>(ranking.ranks.size());
  ranked.variance = ranked.n * (ranked.n + 1) / 12 - ranking.tie_sum() / (12 * (ranked.n - 1));
  auto rank = ranking.ranks.begin();
  for (const auto& group : groups) {
    double sum = 0;
    for (std::size_t i = 0; i < group.size(); ++i) sum += *rank++;
    ranked.mean_ranks.push_back(sum / static_cast<double>(group.size()));
  }
  const bool all_equal = ranking.ties.size() == 1 && ranking.ties.front() == ranking.ranks.size();
  if (all_equal) ranked.undefined = "all values are equal";
  return ranked;
}

}  // namespace

KruskalWallis kruskal_wallis(std::span<const std::vector<double>> groups) {
  const RankedGroups ranked = rank_groups(groups);
  KruskalWallis test{.mean_ranks = ranked.mean_ranks, .undefined = ranked.undefined};
  if (!test.undefined.empty()) return test;
  double between = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const double deviation = ranked.mean_ranks[i] - (ranked.n + 1) / 2;
    between += static_cast<double>(groups[i].size()) * deviation * deviation;
  }
  test.H = between / ranked.variance;
  test.df = static_cast<int>(groups.size()) - 1;
  test.p = chi_squared_upper_tail(test.H, test.df);
  test.epsilon_squared = test.H / (ranked.n - 1);
  return test;
}

}  // namespace ikbench::statistics
