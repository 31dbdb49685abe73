// An interval of the median that holds for any distribution: two order statistics, by the binomial of one half
// (Thompson, Annals of Mathematical Statistics 7 (1936) 122).
#pragma once

#include <span>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// The median of sorted values (ranked_values) with its interval, at least at the level; more where values are equal.
// Infinite values are ranked like any other. Too few values, fewer than 6 at 0.95, have no interval.
Estimate median_interval(std::span<const double> sorted, double level);

}  // namespace ikbench::statistics
