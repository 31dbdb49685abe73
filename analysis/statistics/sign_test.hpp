// Tests which of two is ahead in more pairs. The sign test is Friedman's for two groups, made exact: ranks within a
// pair have no scale (Conover, Practical Nonparametric Statistics (1999), sections 3.4 and 5.8).
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct SignTest {
  int above = 0;           // pairs in which first is the larger
  int below = 0;           // pairs in which second is the larger
  int ties = 0;            // left out
  double p = not_defined;  // two-sided, exact
  int direction = 0;       // 1 if above is the larger, -1 if below is, 0 if they are equal
  std::string undefined;   // why there is no p; empty if there is one
};

// Tests first - second, pair by pair, without differences by rounding alone (rounding.hpp). Two infinite values of one
// sign are equal. Samples of different sizes have no p.
SignTest sign_test(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
