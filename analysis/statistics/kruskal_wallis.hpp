// Tests whether several groups come from one distribution. Kruskal and Wallis, JASA 47 (1952) 583, by the ranks of all
// values together, corrected for ties.
#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/ranks.hpp"

namespace ikbench::statistics {

struct KruskalWallis : Test {            // the statistic is H
  double epsilon_squared = not_defined;  // H / (n - 1), 0 to 1: the share of the ranks' spread that is between groups
  std::vector<double> mean_ranks = {};   // by group
};

KruskalWallis kruskal_wallis(std::span<const std::vector<double>> groups);

}  // namespace ikbench::statistics
