// Descriptive statistics of one group: n, mean, standard deviation, quantiles, and the effect size that articles print.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::judge {

// NaN: not known, of a summary or of no values.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Descriptives {
  int n = 0;
  double mean = unknown;
  double sd = unknown;  // divided by n - 1; not known where values count as the tolerance
  double median = unknown, lower_quartile = unknown, upper_quartile = unknown;  // Hyndman and Fan's type 5, MATLAB's
  double quantile_95 = unknown;                                                 // of the same type
  double smallest = unknown, largest = unknown;
};

Descriptives describe(const Group& group);
Descriptives describe_values(const std::vector<double>& values);
// Of values that rise, which are not none.
double quantile(const std::vector<double>& sorted, double share);

// The difference of two means in pooled standard deviations, without bias (Hedges, J. Educational Statistics 6 (1981)
// 107); of paired values that is g_av, by the spreads of both and not by that of their differences (Cumming,
// Understanding the New Statistics, 2012, chapter 11). None without spread.
std::optional<double> hedges_g(const SummaryStatistics& first, const SummaryStatistics& second);

}  // namespace ikbench::judge
