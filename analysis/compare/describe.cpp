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

Description describe(const Group& group) {
  if (group.summary) return {.n = group.summary->n, .mean = group.summary->mean, .sd = group.summary->sd};
  if (group.values.empty()) return {};
  const Summary summary = summarise(group.values);
  std::vector<double> sorted = group.values;
  std::ranges::sort(sorted);
  const bool is_finite = std::isfinite(sorted.back());
  return {.n = summary.n,
          .mean = is_finite ? summary.mean : sorted.back(),
          .sd = summary.n > 1 && group.at_most == 0 && is_finite ? summary.sd : unknown,
          .median = quantile(sorted, 0.5),
          .lower_quartile = quantile(sorted, 0.25),
          .upper_quartile = quantile(sorted, 0.75),
          .quantile_95 = quantile(sorted, 0.95),
          .smallest = sorted.front(),
          .largest = sorted.back()};
}

std::optional<TestOfAll> anova(const Observations& observed) {
  const auto is_known = [](const Group& group) {
    return group.copies == 0 && group.lost == 0 && !group.is_apart && (group.summary || !group.values.empty());
  };
  if (observed.groups.size() < 2 || observed.is_paired || !std::ranges::all_of(observed.groups, is_known)) return {};
  // Means less a common value keep the digits that many equal leading ones would cost.
  const double shift = observed.groups.front().summary ? 0 : observed.groups.front().values.front();
  std::vector<Summary> groups;
  double n = 0, sum = 0;
  for (const Group& group : observed.groups) {
    std::vector<double> shifted = group.values;
    for (double& value : shifted) value -= shift;
    groups.push_back(group.summary ? *group.summary : summarise(shifted));
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
