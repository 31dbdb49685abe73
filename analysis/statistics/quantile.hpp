// Sample quantiles: the nine definitions of Hyndman and Fan, The American Statistician 50 (1996) 361.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

enum class QuantileType { type_1 = 1, type_2, type_3, type_4, type_5, type_6, type_7, type_8, type_9 };

// The rank of NaN, if smaller is better.
constexpr double worse_than_every_number = std::numeric_limits<double>::infinity();

// Sorts values; NaN comes last, as infinity. Infinite values stay.
std::vector<double> ranked_values(std::span<const double> values);

// The p-quantile of sorted values, 0 <= p <= 1; NaN if there are none. Type 5 is MATLAB's, 7 that of R and NumPy.
double quantile(std::span<const double> sorted, double p, QuantileType type);

// The number of decades that nine tenths of the values span: log10 of the 95 % quantile by the 5 % quantile. Not
// defined if either is not positive or not finite.
double decades(std::span<const double> values);

// An interval of the median that holds for any distribution: two order statistics, by the binomial of one half
// (Thompson, Annals of Mathematical Statistics 7 (1936) 122).

// The median of sorted values (ranked_values) with its interval, at least at the level; more where values are equal.
// Infinite values are ranked like any other. Too few values, fewer than 6 at 0.95, have no interval.
Estimate median_interval(std::span<const double> sorted, double level);

}  // namespace ikbench::statistics
