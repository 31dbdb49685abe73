// Tails and quantiles of the normal and the chi-square distribution, as tests and intervals ask for them.
#pragma once

namespace ikbench::statistics {

// P(|Z| >= |z|) of the standard normal; NaN where z is NaN.
double normal_two_sided(double z);

// The standard normal's quantile: infinite at 0 and 1, NaN for what is not a probability.
double normal_quantile(double p);

// The z that `level` of the standard normal lies within: 1.96 for 0.95. A level outside (0, 1) is
// std::invalid_argument.
double normal_critical(double level);

// P(X >= x) of chi-square; NaN where x is not a finite number of at least 0 or df is less than 1.
double chi_squared_upper_tail(double x, double df);

// Refuses a confidence level outside (0, 1) by std::invalid_argument.
void check_level(double level);

}  // namespace ikbench::statistics
