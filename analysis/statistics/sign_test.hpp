// Which of two is ahead in more pairs? The sign test, which is Friedman's of two groups, made exact: ranks within a
// pair know no scale (Conover, Practical Nonparametric Statistics (1999), sections 3.4 and 5.8).
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct SignTest {
  int above = 0;           // pairs in which first is the larger
  int below = 0;           // in which second is
  int ties = 0;            // left out
  double p = not_defined;  // two-sided, exact
  int direction = 0;       // 1 where above is the larger, -1 where below is, 0 where they are equal
  std::string undefined;   // why there is no p; empty where there is
};

// Of first - second, pair by pair, without what rounding alone puts between them (rounding.hpp). Two infinite values of
// one sign are equal. Samples of different sizes have no p.
SignTest sign_test(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
