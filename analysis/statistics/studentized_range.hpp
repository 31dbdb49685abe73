// The studentized range: the largest difference among k means of equal expectation, in units of their standard error
// estimated on df degrees of freedom (Tukey 1953; the double integral as in Copenhaver and Holland 1988).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ikbench::statistics {

// P(Q > q) of k groups, k a whole number from 2 to 1000, df from 1 to infinity; NaN outside. q <= 0 has the tail 1. It
// is summed from positive terms, never as 1 - cdf, so small tails have their digits too: relative error below 1e-13 to
// k = 200 and 1e-10 to k = 1000 down to tails of 1e-250 (against sums of half the step, the t distribution for k = 2
// and a quadrature in thirty digits); below some 1e-265 it is 0. A twentieth to a few tenths of a millisecond.
double studentized_range_upper_tail(double q, double k, double df);

// The same for many calls with one k, and quantiles: the range of k normal variables is tabulated (some tenths of a
// millisecond; to k = 6 once for all), after which a tail costs some microseconds. Relative error below 1e-10 to k =
// 400, 3e-10 to k = 1000.
class StudentizedRange {
 public:
  explicit StudentizedRange(double k);
  double upper_tail(double q, double df) const;
  // The q with P(Q <= q) = p, 0 <= p <= 1; NaN outside, and for 0 < p < 1e-9, which 1 - p does not resolve.
  double quantile(double p, double df) const;

 private:
  static constexpr std::size_t terms = 24;
  using Piece = std::array<double, terms>;
  using Table = std::vector<Piece>;  // Chebyshev series of ln P(range > w)

  static Table tabulated(int k);
  double range_tail(double w) const;

  double k_;
  Table table_;  // empty if k is out of range
};

}  // namespace ikbench::statistics
