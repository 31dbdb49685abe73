// A rank statistic's distribution if there is no difference, and the p and the interval of a shift that follow from it.
// Hollander, Wolfe and Chicken, Nonparametric Statistical Methods (2014), chapter 4.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// Symmetric about its mean. Exact if the probabilities of 0, 1, 2, ... are given, else normal.
struct RankDistribution {
  std::vector<double> probabilities;
  double mean = 0;
  double standard_deviation = 0;  // of the normal distribution, corrected for ties

  // Twice the smaller tail, at most 1; the normal's with a continuity correction of one half.
  double two_sided(double statistic) const;
  int direction(double statistic) const { return sign_of(statistic - mean); }
  // The largest r with P(statistic < r) <= (1 - level) / 2: the interval of a shift runs from the r-th smallest
  // difference to the r-th largest. 0 if there are too few values for the level.
  std::uint64_t interval_rank(double level) const;
  std::string method() const;  // "exact" or "normal approximation"
};

}  // namespace ikbench::statistics
