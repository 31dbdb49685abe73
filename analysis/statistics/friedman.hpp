// Tests whether several groups differ, each measured on the same blocks. Friedman, JASA 32 (1937) 675; the F of Iman
// and Davenport, Communications in Statistics A9 (1980) 571; Kendall's W; and the critical difference of Demsar, JMLR 7
// (2006) 1.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/statistics/ranks.hpp"

namespace ikbench::statistics {

// The statistic is F, infinite if all blocks agree; p is then the chance of that.
struct Friedman : Test {
  std::vector<double> average_ranks = {};  // by group, also for one block; 1 is a block's smallest value
  double kendall_w = not_defined;          // 0 (blocks disagree) to 1 (all rank alike), corrected for ties
};

// One vector per group, one value per block. The smallest value of a block has rank 1; negate values if larger is
// better.
Friedman friedman(std::span<const std::vector<double>> groups);

// Average ranks that are further apart differ. q_alpha is the studentized range's quantile at infinite degrees of
// freedom by sqrt 2 (Nemenyi). NaN if there are fewer than two groups or no blocks.
double critical_difference(double q_alpha, std::size_t groups, std::size_t blocks);

}  // namespace ikbench::statistics
