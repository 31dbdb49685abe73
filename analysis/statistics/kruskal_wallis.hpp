// Do several groups come from one distribution? Kruskal and Wallis, JASA 47 (1952) 583; and which pairs differ: Dunn,
// Technometrics 6 (1964) 241. Both by the ranks of all values together, corrected for ties.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/ranks.hpp"

namespace ikbench::statistics {

struct KruskalWallis {
  double H = not_defined;
  int df = 0;
  double p = not_defined;                // upper tail of chi-square
  double epsilon_squared = not_defined;  // H / (n - 1), 0 to 1: the share of the ranks' spread that is between groups
  std::vector<double> mean_ranks;        // of the groups in their order
  std::string undefined;                 // why there is no H; empty where there is
};

KruskalWallis kruskal_wallis(std::span<const std::vector<double>> groups);

// z and its raw p for every pair first < second. All groups are ranked together,
// whichever pairs are asked for. z is that of mean rank of `first` less mean rank of `second`.
std::vector<RankComparison> dunn(std::span<const std::vector<double>> groups);

}  // namespace ikbench::statistics
