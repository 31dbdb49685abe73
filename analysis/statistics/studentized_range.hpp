// The studentized range: the largest difference among k means of equal expectation, in units of their standard error
// estimated on df degrees of freedom (Tukey 1953; the double integral as in Copenhaver and Holland 1988).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ikbench {

// P(Q > q) of k groups, k a whole number from 2 to 1000, df from 1 to infinity; NaN outside. q <= 0 has the tail 1.
// Summed from positive terms, never as 1 - cdf: the relative error is below 1e-10 (1e-12 to k = 100) down to tails of
// 1e-250, as tests hold it to, against the t distribution (k = 2) and against sums of other steps; beyond 1e-270 it is
// 0.
double studentized_range_upper_tail(double q, double k, double df);

// The q with P(Q <= q) = p, 0 <= p <= 1; NaN outside. For p below 1e-5 the digits of 1 - p are those there are.
double studentized_range_quantile(double p, double k, double df);

// The same two functions for many calls with one k: the range of k normal variables is tabulated once (a fraction of a
// millisecond), after which a tail costs some microseconds.
class StudentizedRange {
 public:
  explicit StudentizedRange(double k);
  double upper_tail(double q, double df) const;
  double quantile(double p, double df) const;

 private:
  static constexpr std::size_t terms = 24;
  using Piece = std::array<double, terms>;

  double range_tail(double w) const;

  double k_;
  std::vector<Piece> pieces_;  // Chebyshev series of ln P(range > w); none where k is out of range
};

}  // namespace ikbench
