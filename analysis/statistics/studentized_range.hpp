// The studentized range: the largest difference among k means of equal expectation, in units of their standard error
// estimated on df degrees of freedom (Tukey 1953; the double integral as in Copenhaver and Holland 1988).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ikbench::statistics {

// Tails for k groups, k a whole number from 2 to 1000, and df from 1 to infinity. The range of k normal
// variables is tabulated once (some tenths of a millisecond; to k = 6 once for all), after which a tail costs some
// microseconds. Tails are summed from positive terms, never as 1 - cdf, so small ones have their digits too: relative
// error below 1e-10 to k = 400 and 3e-10 to k = 1000 down to tails of 1e-250; below some 1e-265 they are 0.
class StudentizedRange {
 public:
  explicit StudentizedRange(double k);
  // P(Q > q); 1 for q <= 0, NaN for a k or df out of range.
  double upper_tail(double q, double df) const;

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
