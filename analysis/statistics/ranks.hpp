// Ranks of a pooled sample; equal values share the mean of their ranks (midranks).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct Ranking {
  std::vector<double> ranks;      // by value, in their order; 1 is the smallest
  std::vector<std::size_t> ties;  // for each value that occurs more than once, ascending: how often
  std::string undefined;          // why there are no ranks; empty if there are

  bool all_equal() const { return ties.size() == 1 && ties.front() == ranks.size(); }
  double tie_sum() const;  // sum of t^3 - t over the ties, by which they reduce a rank statistic's variance
};

// Ranks infinite values like any other; if one value is NaN, none has a rank.
Ranking midranks(std::span<const double> values);
Ranking midranks(std::span<const double> first, std::span<const double> second);  // of both together

// The values of all groups, one group after the other.
std::vector<double> pooled(std::span<const std::vector<double>> groups);

struct RankTest : Test {
  double effect = not_defined;          // 0 to 1
  std::vector<double> mean_ranks = {};  // by group
};

// Tests whether several groups come from one distribution. Kruskal and Wallis, JASA 47 (1952) 583, by the ranks of all
// values together, corrected for ties.

// The statistic is H; the effect is epsilon^2 = H / (n - 1), the share of the ranks' spread that is between groups.
RankTest kruskal_wallis(std::span<const std::vector<double>> groups);

}  // namespace ikbench::statistics
