// Tests whether two independent samples come from one distribution, or one is larger. Mann and Whitney, Annals of
// Mathematical Statistics 18 (1947) 50.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "analysis/statistics/rank_statistic.hpp"
#include "analysis/statistics/ranks.hpp"

namespace ikbench::statistics {

struct MannWhitney {
  double U = not_defined;  // pairs in which the value of `first` is the larger, an equal pair counted half (R's W)
  double p = not_defined;  // two-sided
  int direction = 0;       // 1 if U is above its mean: `first` is the larger; -1 below, 0 at it
  std::string method;      // "exact": both samples have fewer than 50 values and no two values are equal; else
                           // "normal approximation", corrected for ties and continuity
  std::string undefined;   // why there is no p; empty if there is one
};

MannWhitney mann_whitney(std::span<const double> first, std::span<const double> second);

// The distribution of U if samples of n1 and n2 values do not differ; `ranking` is of all their values.
RankDistribution distribution_of_u(std::size_t n1, std::size_t n2, const Ranking& ranking);

}  // namespace ikbench::statistics
