// Tails and quantiles of the normal and the chi-square distribution, for tests and intervals.
#pragma once

namespace ikbench::statistics {

// P(|Z| >= |z|) of the standard normal; NaN if z is NaN.
double normal_two_sided(double z);

// The standard normal's quantile: infinite at 0 and 1, NaN outside [0, 1].
double normal_quantile(double p);

// The z that encloses `level` of the standard normal: 1.96 for 0.95. Throws std::invalid_argument for a level outside
// (0, 1).
double normal_critical(double level);

// P(X >= x) of chi-square; NaN if x is not a finite number of at least 0 or df is less than 1.
double chi_squared_upper_tail(double x, double df);

// Throws std::invalid_argument for a confidence level outside (0, 1).
void check_level(double level);

}  // namespace ikbench::statistics
