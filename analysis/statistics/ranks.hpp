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

// Tests whether several groups differ, each measured on the same blocks. Friedman, JASA 32 (1937) 675; the F of Iman
// and Davenport, Communications in Statistics A9 (1980) 571; Kendall's W; and the critical difference of Demsar, JMLR 7
// (2006) 1.

// The statistic is F, infinite if all blocks agree; p is then the chance of that. The effect is Kendall's W: 0 (blocks
// disagree) to 1 (all rank alike), corrected for ties. Ranks are known for one block, too; 1 is a block's smallest
// value. One vector per group, one value per block. The smallest value of a block has rank 1; negate values if larger
// is better.
RankTest friedman(std::span<const std::vector<double>> groups);

// Average ranks that are further apart differ. q_alpha is the studentized range's quantile at infinite degrees of
// freedom by sqrt 2 (Nemenyi). NaN if there are fewer than two groups or no blocks.
double critical_difference(double q_alpha, std::size_t groups, std::size_t blocks);

// Tests which of two is ahead in more pairs. The sign test is Friedman's for two groups, made exact: ranks within a
// pair have no scale (Conover, Practical Nonparametric Statistics (1999), sections 3.4 and 5.8).
// Leaves out ties, and differences by rounding alone (rounding.hpp). Two infinite values of one sign are equal. Samples
// of different sizes have no p. p is exact.
Test sign_test(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
