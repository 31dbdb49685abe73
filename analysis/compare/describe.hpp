// Describes groups, and tests whether they differ at all, as the paper's Tables 3 to 6 do.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "analysis/compare/observations.hpp"

namespace ikbench::compare {

// NaN: not known, of a summary or of no values.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Description {
  int n = 0;
  double mean = unknown;
  double sd = unknown;  // divided by n - 1; not known where values count as the tolerance
  double median = unknown, lower_quartile = unknown, upper_quartile = unknown;  // Hyndman and Fan's type 5, MATLAB's
  double quantile_95 = unknown;                                                 // of the same type
  double smallest = unknown, largest = unknown;
};

Description describe(const Group& group);
Description described(const std::vector<double>& values);

struct TestOfAll {
  double statistic = 0;
  double df = 0, df_within = 0;
  double p = 1;
  double ss_between = 0, ss_within = 0;  // of ANOVA
};

// None for fewer than two groups, paired ones, copies, lost values, or groups without spread.
std::optional<TestOfAll> anova(const Observations& observed);

}  // namespace ikbench::compare
