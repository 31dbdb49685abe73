#include "analysis/compare/describe.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "analysis/compare/tests_of_two.hpp"

namespace ikbench::compare {
namespace {

double quantile(const std::vector<double>& sorted, double share) {
  const auto n = static_cast<double>(sorted.size());
  const double place = std::clamp(n * share - 0.5, 0.0, n - 1), part = place - std::floor(place);
  const double low = sorted[static_cast<std::size_t>(place)];
  const double high = sorted[std::min(static_cast<std::size_t>(place) + 1, sorted.size() - 1)];
  return low == high || part == 0 ? low : (1 - part) * low + part * high;
}

}  // namespace

Description described(const std::vector<double>& values) {
  if (values.empty()) return {};
  const Summary summary = summarise(values);
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  const bool is_finite = std::isfinite(sorted.back());
  return {.n = summary.n,
          .mean = is_finite ? summary.mean : sorted.back(),
          .sd = summary.n > 1 && is_finite ? summary.sd : unknown,
          .median = quantile(sorted, 0.5),
          .lower_quartile = quantile(sorted, 0.25),
          .upper_quartile = quantile(sorted, 0.75),
          .quantile_95 = quantile(sorted, 0.95),
          .smallest = sorted.front(),
          .largest = sorted.back()};
}

Description describe(const Group& group) {
  const auto* printed = std::get_if<Summary>(&group.sample);
  if (untold(group) && untold(group)->printed) printed = &*untold(group)->printed;
  if (printed) return {.n = printed->n, .mean = printed->mean, .sd = printed->sd};
  const std::span<const double> values = values_of(group);
  Description its = described({values.begin(), values.end()});
  if (group.at_most > 0) its.sd = unknown;
  return its;
}

std::optional<TestOfAll> anova(const Observations& observed) {
  const auto is_known = [](const Group& group) {
    const auto* const measured = std::get_if<Measured>(&group.sample);
    return std::holds_alternative<Summary>(group.sample) || (measured && !measured->values.empty());
  };
  if (observed.groups.size() < 2 || observed.is_paired || !std::ranges::all_of(observed.groups, is_known)) return {};
  // Means less a common value keep the digits that many equal leading ones would cost.
  const std::span<const double> of_first = values_of(observed.groups.front());
  const double shift = of_first.empty() ? 0 : of_first.front();
  std::vector<Summary> groups;
  double n = 0, sum = 0;
  for (const Group& group : observed.groups) {
    std::vector<double> shifted(values_of(group).begin(), values_of(group).end());
    for (double& value : shifted) value -= shift;
    const auto* const printed = std::get_if<Summary>(&group.sample);
    groups.push_back(printed ? *printed : summarise(shifted));
    n += groups.back().n;
    sum += groups.back().n * groups.back().mean;
  }
  TestOfAll test{.df = static_cast<double>(groups.size()) - 1, .df_within = n - static_cast<double>(groups.size())};
  for (const Summary& group : groups) {
    test.ss_between += group.n * (group.mean - sum / n) * (group.mean - sum / n);
    test.ss_within += (group.n - 1) * group.sd * group.sd;
  }
  // Squares of the largest numbers have no place in a double.
  if (test.df_within < 1 || test.ss_within == 0 ||
      !(test.ss_between + test.ss_within < std::numeric_limits<double>::infinity()))
    return {};
  test.statistic = test.ss_between / test.df / (test.ss_within / test.df_within);
  const boost::math::fisher_f f(test.df, test.df_within);
  test.p = boost::math::cdf(boost::math::complement(f, test.statistic));
  return test;
}

}  // namespace ikbench::compare
