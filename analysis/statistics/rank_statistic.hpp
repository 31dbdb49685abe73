// What the two tests of Wilcoxon share: a rank statistic's distribution under no difference, the p and the interval of
// a shift that follow from it. Hollander, Wolfe and Chicken, Nonparametric Statistical Methods (2014), chapters 3
// and 4.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// Symmetric about its mean. Where the probabilities of 0, 1, 2, ... are given it is exact, else it is taken as normal.
struct RankDistribution {
  std::vector<double> probabilities;
  double mean = 0;
  double standard_deviation = 0;  // of the normal, corrected for ties

  // Twice the smaller tail, at most 1; the normal's with a continuity correction of one half.
  double two_sided(double statistic) const;
  int direction(double statistic) const { return sign_of(statistic - mean); }
  // The largest r with P(statistic < r) <= (1 - level) / 2: the interval runs from the r-th smallest difference to the
  // r-th largest. 0 where there are too few values for the level.
  std::size_t interval_rank(double level) const;
  std::string method() const;  // "exact" or "normal approximation"
};

// Hodges and Lehmann's estimate (Annals of Mathematical Statistics 34 (1963) 598): the median of all differences.
struct Shift {
  double estimate = not_defined;
  double low = not_defined;
  double high = not_defined;
};

// More differences than this are not looked at, and the shift is not defined.
constexpr std::size_t most_differences = 1'000'000;

// `rank` from interval_rank; no differences give no estimate, rank 0 no interval.
Shift shift_of(std::vector<double> differences, std::size_t rank);

}  // namespace ikbench::statistics
