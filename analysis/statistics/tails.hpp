// Tails and quantiles of the normal, the chi-square and Student's t distribution, from Boost.Math.
#pragma once

namespace ikbench::statistics {

// P(|Z| >= |z|) of the standard normal; NaN if z is NaN.
double normal_two_sided(double z);

// The standard normal's quantile: infinite at 0 and 1, NaN outside [0, 1].
double normal_quantile(double p);

// The z that encloses `level` of the standard normal: 1.96 for 0.95. Throws std::invalid_argument for a level outside
// (0, 1).
double normal_critical(double level);

// Student's t, for every argument: NaN if there is no answer, never an exception.

// P(T > t), df > 0.
double t_upper_tail(double t, double df);
// The t with P(T <= t) = p, 0 < p < 1, df > 0.
double t_quantile(double p, double df);

// P(X >= x) of chi-square; NaN if x is not a finite number of at least 0 or df is less than 1.
double chi_squared_upper_tail(double x, double df);

// Throws std::invalid_argument for a confidence level outside (0, 1).
void check_level(double level);

}  // namespace ikbench::statistics
