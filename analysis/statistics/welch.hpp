// Tests of means: Welch's analysis of groups of unequal variance; Student's for pairs, and his interval of a mean
// (Biometrika 6 (1908) 1). Welch's test of two groups is multiple_comparisons.hpp's.
#pragma once

#include <span>

#include "analysis/statistics/multiple_comparisons.hpp"

namespace ikbench::statistics {

// Welch's analysis of variance, by F: tests whether groups of unequal variances have the same mean (Biometrika 38
// (1951) 330).
Test welch_anova(std::span<const GroupSummary> groups);

// Student's test of the differences a_i - b_i; p is that of this pair alone. Throws std::invalid_argument if the sizes
// differ, or `level` is not between 0 and 1.
MeanDifference paired_t(std::span<const double> a, std::span<const double> b, double level);

// The mean with Student's t interval; for a constant group its one value. Throws std::invalid_argument if `level` is
// not between 0 and 1.
Estimate mean_interval(const GroupSummary& group, double level);

}  // namespace ikbench::statistics
