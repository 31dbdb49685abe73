// The size of a difference, whatever its p: shares of variance, standardized mean differences, and the dominance of one
// sample over another.
#pragma once

#include <span>

#include "analysis/statistics/anova.hpp"

namespace ikbench::statistics {

// The share of the variance between groups, corrected for chance, so possibly below 0 (Olejnik and Algina,
// Psychological Methods 8 (2003) 434); not defined if the table has no sums of squares.
double omega_squared(const AnovaTable& table);

// (mean of a - mean of b) / pooled standard deviation, whose squares are weighted by n - 1 (Cohen 1988), times Hedges's
// exact correction for small samples (J. Educational Statistics 6 (1981) 107). Not defined if a group has fewer than
// two values, both have no spread, or a mean, a spread or g itself is not finite.
double hedges_g(const GroupSummary& a, const GroupSummary& b);

// P(a > b) - P(a < b) of a random pair: 1 if every value of a is above every value of b. Infinities have their ranks,
// NaN has none. Interval: Cliff's asymmetric one with his consistent variance (Psychological Bulletin 114 (1993) 494).
// If one sample lies wholly above the other, that variance is 0, and the limit is (n - z^2) / (n + z^2), n the smaller
// sample (Feng and Cliff, J. Modern Applied Statistical Methods 3 (2004) 322): Wilson's limit of n successes in n.
Estimate cliffs_delta(std::span<const double> a, std::span<const double> b, double level);
// P(a > b) + P(a = b) / 2 = (delta + 1) / 2 (Vargha and Delaney, J. Educational and Behavioral Statistics 25 (2000)
// 101).
Estimate vargha_delaney(std::span<const double> a, std::span<const double> b, double level);

}  // namespace ikbench::statistics
