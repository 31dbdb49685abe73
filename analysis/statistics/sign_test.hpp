// Tests which of two is ahead in more pairs. The sign test is Friedman's for two groups, made exact: ranks within a
// pair have no scale (Conover, Practical Nonparametric Statistics (1999), sections 3.4 and 5.8).
#pragma once

#include <span>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// Tests first - second, pair by pair, without differences by rounding alone (rounding.hpp). Two infinite values of one
// sign are equal. Samples of different sizes have no p. Ties are left
// out. p is exact.
Test sign_test(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
