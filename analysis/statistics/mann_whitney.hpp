// Tests whether two independent samples come from one distribution, or one is larger. Mann and Whitney, Annals of
// Mathematical Statistics 18 (1947) 50.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/ranks.hpp"

namespace ikbench::statistics {

// A rank statistic's distribution if there is no difference (Hollander, Wolfe and Chicken, Nonparametric Statistical
// Methods (2014), chapter 4). Symmetric about its mean. Exact if the probabilities of 0, 1, 2, ... are given, else
// normal.
struct RankDistribution {
  std::vector<double> probabilities;
  double mean = 0;
  double standard_deviation = 0;  // of the normal distribution, corrected for ties

  // Twice the smaller tail, at most 1; the normal's with a continuity correction of one half.
  double two_sided(double statistic) const;
  // The largest r with P(statistic < r) <= (1 - level) / 2: the interval of a shift runs from the r-th smallest
  // difference to the r-th largest. 0 if there are too few values for the level.
  std::uint64_t interval_rank(double level) const;
};

// The statistic is U: pairs in which the value of `first` is the larger, an equal pair counted half (R's W). p is exact
// if both samples have fewer than 50 values and no two values are equal; else by a normal approximation, corrected for
// ties and continuity.
Test mann_whitney(std::span<const double> first, std::span<const double> second);

// The distribution of U if samples of n1 and n2 values do not differ; `ranking` is of all their values.
RankDistribution distribution_of_u(std::size_t n1, std::size_t n2, const Ranking& ranking);

// Tests whether a value of one sample is as often below as above one of the other, whatever their spreads. Brunner and
// Munzel,
// Biometrical J. 42 (2000) 17.

// The statistic is positive if `first` is the larger, and infinite if no two values overlap. Then no variance is left
// to test with, and p is that of the statistic's permutations: 2 n1! n2! / (n1 + n2)! (Neubert and Brunner,
// Computational Statistics & Data Analysis 51 (2007) 5192). df are of Student's t, by Satterthwaite.
Test brunner_munzel(std::span<const double> first, std::span<const double> second);

// The shift of one sample against another: the median of all differences of a value of the first and a value of the
// second. Hodges and Lehmann, Annals of Mathematical Statistics 34 (1963) 598.

// The shift first - second, with the interval of the Mann-Whitney test: from the r-th smallest difference to the r-th
// largest, where P(U < r) is at most (1 - level) / 2, exactly or about as in the test (Hollander, Wolfe and Chicken,
// Nonparametric Statistical Methods (2014), chapter 4). Too few values for the level give no interval. Equal infinite
// values differ by 0; others may make the shift infinite. The m n differences are counted
// (Johnson and Mizoguchi, SIAM J. Computing 7 (1978) 147), not made: at most some 60 passes over the sorted samples for
// each of three differences.
Estimate hodges_lehmann(std::span<const double> first, std::span<const double> second, double level);

}  // namespace ikbench::statistics
