#include "analysis/statistics/welch.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

double square(double x) { return x * x; }

// Says why a group can have no weight; empty if it can.
Reason undefined_spread(const GroupSummary& group, std::size_t index) {
  if (group.n < 2) return {index, "{} has fewer than two values, so no spread"};
  if (!std::isfinite(group.mean) || !std::isfinite(group.std) || group.std < 0) {
    return {index, "the mean or the standard deviation of {} is not defined"};
  }
  if (group.std == 0) return {index, "{} is constant"};
  return {};
}

}  // namespace

Test welch_anova(std::span<const GroupSummary> groups) {
  Test test;
  std::vector<double> spreads;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    test.undefined = undefined_spread(groups[i], i);
    if (!test.undefined.empty()) return test;
    spreads.push_back(groups[i].std);
  }
  test.undefined = too_few_groups(groups.size());
  if (!test.undefined.empty()) return test;
  const auto k = static_cast<double>(groups.size());
  const double unit = power_of_two_below(spreads);
  double weights = 0, mean = 0;
  const auto weight_of = [unit](const GroupSummary& group) { return group.n / square(group.std / unit); };
  for (const GroupSummary& group : groups) weights += weight_of(group);
  for (const GroupSummary& group : groups) mean += weight_of(group) / weights * group.mean;
  double between = 0, lambda = 0;
  for (const GroupSummary& group : groups) {
    const double weight = weight_of(group);
    const double deviation = (group.mean - mean) / unit;
    between += weight * deviation * deviation / (k - 1);
    lambda += square(1 - weight / weights) / (group.n - 1);
  }
  lambda *= 3 / (k * k - 1);
  test.statistic = between / (1 + 2 * (k - 2) * lambda / 3);
  test.df = k - 1;
  test.df_within = 1 / lambda;
  test.p = f_upper_tail(test.statistic, test.df, test.df_within);
  if (!std::isfinite(test.p)) test = {.undefined = "the spreads or the means are too far apart for double precision"};
  return test;
}

MeanDifference paired_t(std::span<const double> a, std::span<const double> b, double level) {
  if (a.size() != b.size()) {
    throw std::invalid_argument(fmt::format("pairs of {} and {} values: expected equally many", a.size(), b.size()));
  }
  const GroupSummary summary = summarise(differences_without_rounding(a, b));
  MeanDifference test;
  test.difference = mean_interval(summary, level);
  if (summary.n < 2) {
    test.undefined = "a group of fewer than two values has no spread";
  } else if (!std::isfinite(summary.mean) || !std::isfinite(summary.std)) {
    test.undefined = "a mean or a standard deviation is not defined";
  } else if (std::isnan(test.difference.low)) {
    test.undefined = "the spread is too large for double precision";
  } else if (summary.std == 0) {
    test.undefined = "all pairs differ by the same, so there is no spread";
    test.difference = {.value = summary.mean};
  }
  if (!test.undefined.empty()) return test;
  test.standard_error = summary.std / std::sqrt(summary.n);
  test.df = summary.n - 1;
  test.p = test.p_alone = 2 * t_upper_tail(std::abs(summary.mean / test.standard_error), test.df);
  return test;
}

Estimate mean_interval(const GroupSummary& group, double level) {
  check_level(level);
  const double reach =
      group.n < 2 ? not_defined : -t_quantile((1 - level) / 2, group.n - 1) * group.std / std::sqrt(group.n);
  if (!std::isfinite(group.mean - reach) || !std::isfinite(group.mean + reach)) return {.value = group.mean};
  return {.value = group.mean, .low = group.mean - reach, .high = group.mean + reach};
}

}  // namespace ikbench::statistics
