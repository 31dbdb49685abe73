// Tests whether a sample is normal. Shapiro and Wilk, Biometrika 52 (1965) 591, with Royston's approximations for 3 to
// 5000 values (Applied Statistics 44 (1995) 547, algorithm AS R94; Statistics and Computing 2 (1992) 117).
#pragma once

#include <span>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// The statistic is W. p is small if the sample is not normal.
Test shapiro_wilk(std::span<const double> values);

}  // namespace ikbench::statistics
