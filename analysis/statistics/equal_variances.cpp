#include "analysis/statistics/equal_variances.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

Test bartlett(std::span<const GroupSummary> groups) {
  Test test{.undefined = too_few_groups(groups.size())};
  if (!test.undefined.empty()) return test;
  double largest = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].n < 2) {
      test.undefined = {i, "{} has fewer than two values, so no variance"};
    } else if (std::isinf(groups[i].std)) {
      test.undefined = {i, "the standard deviation of {} is too large for double precision"};
    } else if (!(groups[i].std >= 0)) {
      test.undefined = {i, "the standard deviation of {} is not defined"};
    } else if (groups[i].std == 0) {
      test.undefined = {i, "{} is constant"};
    }
    if (!test.undefined.empty()) return test;
    largest = std::max(largest, groups[i].std);
  }
  double df = 0, pooled = 0, logs = 0, inverses = 0;
  for (const GroupSummary& group : groups) {
    const double own = group.n - 1;
    const double std = group.std / largest;  // the statistic has no unit
    df += own;
    pooled += own * std * std;
    logs += own * 2 * (std::log(group.std) - std::log(largest));
    inverses += 1 / own;
  }
  const auto k = static_cast<double>(groups.size());
  const double statistic = df * std::log(pooled / df) - logs;
  test.df = k - 1;
  test.statistic = std::max(0.0, statistic) / (1 + (inverses - 1 / df) / (3 * (k - 1)));
  test.p = chi_squared_upper_tail(test.statistic, test.df);
  return test;
}

Test brown_forsythe(std::span<const std::vector<double>> groups) {
  std::vector<std::vector<double>> deviations;
  for (const auto& group : groups) {
    const double median = describe(group).median;
    std::vector<double> own, sizes;
    for (const double value : group) {
      const double deviation = std::min(std::abs(value - median), std::numeric_limits<double>::max());
      own.push_back(std::isfinite(value) ? deviation : not_defined);
      sizes.push_back(std::max(std::abs(value), std::abs(median)));
    }
    deviations.push_back(without_rounding(own, sizes));
  }
  Test test = anova(deviations);
  if (!test.undefined.empty()) test.undefined.insert(0, "one-way ANOVA of the deviations from the medians: ");
  return test;
}

}  // namespace ikbench::statistics
