// Descriptive statistics of one group: n, mean, standard deviation and quantiles, and the effect size that articles
// print. `judge` makes them for every group; figures and tables use them for other lists of values, too. Each call
// sorts its values.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::judge {

// The value of a statistic that is not known, such as the median of a printed summary.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Statistics of one sample. NaN: not known.
struct Descriptives {
  int n = 0;
  double mean = unknown;
  double sd = unknown;  // divided by n - 1; not known if values count as the tolerance
  // Quantiles are Hyndman and Fan's type 5, as MATLAB's.
  double median = unknown, lower_quartile = unknown, upper_quartile = unknown;
  double quantile_95 = unknown;
  double smallest = unknown, largest = unknown;
};

// Describes a group, also one that is excluded or has only a printed summary.
Descriptives describe(const Group& group);
// Describes values in any order; all statistics are unknown if there are none. With an infinite value mean is infinite.
Descriptives describe_values(const std::vector<double>& values);
// Returns a quantile (Hyndman and Fan's type 5). `sorted` must be ascending and not empty; `share` is from 0 to 1.
double quantile(const std::vector<double>& sorted, double share);

// Returns the difference of two means in pooled standard deviations, without bias (Hedges, J. Educational Statistics 6
// (1981) 107). For paired values that is g_av, which takes the spreads of both samples and not that of their
// differences (Cumming, Understanding the New Statistics, 2012, chapter 11). Empty if the samples have no spread.
std::optional<double> hedges_g(const SummaryStatistics& first, const SummaryStatistics& second);

}  // namespace ikbench::judge
