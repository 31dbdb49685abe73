// Tests whether several groups differ, each measured on the same blocks. Friedman, JASA 32 (1937) 675; the F of Iman
// and Davenport, Communications in Statistics A9 (1980) 571; Kendall's W; and the critical difference of Demsar, JMLR 7
// (2006) 1.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/ranks.hpp"

namespace ikbench::statistics {

struct Friedman {
  std::size_t blocks = 0;
  std::vector<double> average_ranks;  // by group, also for one block; 1 is a block's smallest value
  double chi_squared = not_defined;   // corrected for ties
  int df = 0;
  double p = not_defined;          // upper tail of chi-square
  double F = not_defined;          // Iman and Davenport; infinite if all blocks agree
  double F_df_between = 0;         // k - 1
  double F_df_within = 0;          // (k - 1) (blocks - 1)
  double F_p = not_defined;        // upper tail; if all blocks agree, the chance of that
  double kendall_w = not_defined;  // 0 (blocks disagree) to 1 (all rank alike)
  std::string undefined;           // why there is no chi_squared; empty if there is one
};

// One vector per group, one value per block. The smallest value of a block has rank 1; negate values if larger is
// better.
Friedman friedman(std::span<const std::vector<double>> groups);

// Average ranks that are further apart differ. q_alpha is the studentized range's quantile at infinite degrees of
// freedom by sqrt 2 (Nemenyi). NaN if there are fewer than two groups or no blocks.
double critical_difference(double q_alpha, std::size_t groups, std::size_t blocks);

}  // namespace ikbench::statistics
