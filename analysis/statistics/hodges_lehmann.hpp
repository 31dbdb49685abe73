// The shift of one sample against another: the median of all differences of a value of the first and a value of the
// second. Hodges and Lehmann, Annals of Mathematical Statistics 34 (1963) 598.
#pragma once

#include <span>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// The shift first - second, with the interval of the Mann-Whitney test: from the r-th smallest difference to the r-th
// largest, where P(U < r) is at most (1 - level) / 2, exactly or about as in the test (Hollander, Wolfe and Chicken,
// Nonparametric Statistical Methods (2014), chapter 4). Too few values for the level give no interval. Equal infinite
// values differ by 0; others may make the shift infinite. The m n differences are counted
// (Johnson and Mizoguchi, SIAM J. Computing 7 (1978) 147), not made: at most some 60 passes over the sorted samples for
// each of three differences.
Estimate hodges_lehmann(std::span<const double> first, std::span<const double> second, double level);

}  // namespace ikbench::statistics
