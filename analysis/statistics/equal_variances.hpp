// Tests whether several groups have the same variance. Bartlett, Proceedings of the Royal Society A 160 (1937) 268, for
// normal values; Brown and Forsythe, JASA 69 (1974) 364 (Levene's test about the medians), for any.
#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// The statistic is chi-squared. Every group needs two values or more that are not all equal.
Test bartlett(std::span<const GroupSummary> groups);

// The F of the analysis of variance of the absolute deviations from the groups' medians. Two values have the same
// deviation, so groups of two have no spread of it.
Test brown_forsythe(std::span<const std::vector<double>> groups);

}  // namespace ikbench::statistics
