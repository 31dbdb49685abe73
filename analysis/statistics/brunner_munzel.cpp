#include "analysis/statistics/brunner_munzel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/statistics/ranks.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
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
