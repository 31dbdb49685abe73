// Student's t and its noncentral form (Johnson, Kotz, Balakrishnan 1995, ch. 31), from Boost.Math, for every argument:
// NaN if there is no answer, never an exception.
#pragma once

namespace ikbench::statistics {

// P(T > t), df > 0.
double t_upper_tail(double t, double df);
// The t with P(T <= t) = p, 0 < p < 1, df > 0.
double t_quantile(double p, double df);

// P((Z + shift) / S > t), Z standard normal, S the square root of chi-squared / df. Beyond a shift of ten thousand it
// leaves out Z, which then changes nothing before the fourth digit.
double noncentral_t_upper_tail(double t, double df, double shift);

}  // namespace ikbench::statistics
