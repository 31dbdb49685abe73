#include "analysis/judge/describe.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <iterator>
#include <numeric>

#include "analysis/judge/prepare.hpp"

namespace ikbench::judge {
namespace {

bool has_chance(const Group& group) {  // in its values
  return std::holds_alternative<Summary>(group.sample) ||
         (!untold(group) && !repeats_itself(group) && !values_of(group).empty());
}

double p_of(const TestOfAll& test) {
  return boost::math::cdf(boost::math::complement(boost::math::fisher_f(test.df, test.df_within), test.statistic));
}

// None without spread but of rounding, or where squares of the largest numbers have no place in a double.
std::optional<TestOfAll> with_f(TestOfAll test) {
  if (!(test.df_within >= 1) || !(test.ss_within > 1e-26 * test.ss_between) || test.ss_within == 0 ||
      !(test.ss_between + test.ss_within < std::numeric_limits<double>::infinity()))
    return {};
  test.statistic = test.ss_between / test.df / (test.ss_within / test.df_within);
  test.p = p_of(test);
  return test;
}

// Of the blocks that all groups have.
std::optional<TestOfAll> anova_of_blocks(const Observations& observed) {
  std::vector<int> common = std::get<Measured>(observed.groups.front().sample).blocks;
  for (const Group& group : observed.groups) {
    std::vector<int> both;
    std::ranges::set_intersection(common, std::get<Measured>(group.sample).blocks, std::back_inserter(both));
    common = std::move(both);
  }
  std::vector<std::vector<double>> columns;
  for (const Group& group : observed.groups) columns.push_back(values_in(common, std::get<Measured>(group.sample)));
  const std::size_t k = columns.size(), n = columns.front().size();
  if (n < 2) return {};
  const double shift = columns.front().front();
  std::vector<double> of_block(n), of_group(k);
  double mean = 0;
  for (std::size_t g = 0; g < k; ++g) {
    for (std::size_t i = 0; i < n; ++i) {
      const double value = columns[g][i] -= shift;
      of_group[g] += value / static_cast<double>(n), of_block[i] += value / static_cast<double>(k);
    }
    mean += of_group[g] / static_cast<double>(k);
  }
  TestOfAll test{.name = "ANOVA of repeated measures",
                 .df = static_cast<double>(k - 1),
                 .df_within = static_cast<double>((k - 1) * (n - 1)),
                 .ss_between = 0,
                 .ss_within = 0};
  for (std::size_t g = 0; g < k; ++g) {
    test.ss_between += static_cast<double>(n) * (of_group[g] - mean) * (of_group[g] - mean);
    for (std::size_t i = 0; i < n; ++i) {
      columns[g][i] -= of_group[g] + of_block[i] - mean;
      test.ss_within += columns[g][i] * columns[g][i];
    }
  }
  double squares = 0;  // of the covariances of what is left
  for (const auto& one : columns)
    for (const auto& other : columns)
      squares += std::pow(std::inner_product(one.begin(), one.end(), other.begin(), 0.0) / test.ss_within, 2);
  test.epsilon = 1 / (test.df * squares);
  return with_f(test);
}

// The groups' own, or printed, less a common value, which keeps the digits that many equal leading ones would cost.
std::vector<Summary> summaries_of(const Observations& observed) {
  const std::span<const double> of_first = values_of(observed.groups.front());
  const double shift = of_first.empty() ? 0 : of_first.front();
  std::vector<Summary> summaries;
  for (const Group& group : observed.groups) {
    std::vector<double> shifted(values_of(group).begin(), values_of(group).end());
    for (double& value : shifted) value -= shift;
    const auto* const printed = std::get_if<Summary>(&group.sample);
    summaries.push_back(printed ? *printed : summarise(shifted));
  }
  return summaries;
}

}  // namespace

double quantile(const std::vector<double>& sorted, double share) {
  const auto n = static_cast<double>(sorted.size());
  const double place = std::clamp(n * share - 0.5, 0.0, n - 1), part = place - std::floor(place);
  const double low = sorted[static_cast<std::size_t>(place)];
  const double high = sorted[std::min(static_cast<std::size_t>(place) + 1, sorted.size() - 1)];
  return low == high || part == 0 ? low : (1 - part) * low + part * high;
}

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

std::optional<double> hedges_g(const Summary& first, const Summary& second) {
  const double df = first.n + second.n - 2;
  const double squares = (first.n - 1) * first.sd * first.sd + (second.n - 1) * second.sd * second.sd;
  if (!(squares > 0) || !(df > 1)) return {};
  const double unbiased = std::exp(std::lgamma(df / 2) - std::lgamma((df - 1) / 2)) / std::sqrt(df / 2);
  return unbiased * (first.mean - second.mean) / std::sqrt(squares / df);
}

std::optional<TestOfAll> anova(const Observations& observed) {
  if (observed.groups.size() < 2 || !std::ranges::all_of(observed.groups, has_chance)) return {};
  if (observed.is_paired) return anova_of_blocks(observed);
  const std::vector<Summary> groups = summaries_of(observed);
  double n = 0, sum = 0;
  for (const Summary& group : groups) n += group.n, sum += group.n * group.mean;
  TestOfAll test{.name = "ANOVA",
                 .df = static_cast<double>(groups.size()) - 1,
                 .df_within = n - static_cast<double>(groups.size()),
                 .ss_between = 0,
                 .ss_within = 0};
  for (const Summary& group : groups) {
    test.ss_between += group.n * (group.mean - sum / n) * (group.mean - sum / n);
    test.ss_within += (group.n - 1) * group.sd * group.sd;
  }
  return with_f(test);
}

std::optional<TestOfAll> anova_of_unequal(const Observations& observed, const std::optional<TestOfAll>& plain) {
  if (!plain || (observed.is_paired && plain->df < 2)) return {};
  TestOfAll test{.name = "Greenhouse-Geisser",
                 .statistic = plain->statistic,
                 .df = plain->df * plain->epsilon,
                 .df_within = plain->df_within * plain->epsilon,
                 .epsilon = plain->epsilon};
  if (!observed.is_paired) {
    const double k = plain->df + 1;
    double weights = 0, mean = 0, lost = 0;
    const std::vector<Summary> groups = summaries_of(observed);
    const auto weight = [](const Summary& group) { return group.n / (group.sd * group.sd); };
    for (const Summary& group : groups) {
      if (group.n < 2 || !(group.sd > 0)) return {};
      weights += weight(group), mean += weight(group) * group.mean;
    }
    mean /= weights;
    test = {.name = "Welch's ANOVA", .statistic = 0, .df = plain->df};
    for (const Summary& group : groups) {
      lost += std::pow(1 - weight(group) / weights, 2) / (group.n - 1);
      test.statistic += weight(group) * std::pow(group.mean - mean, 2) / test.df;
    }
    test.statistic /= 1 + 2 * (k - 2) / (k * k - 1) * lost;
    test.df_within = (k * k - 1) / (3 * lost);
  }
  test.p = p_of(test);
  return test;
}

double critical_difference(std::size_t groups, std::size_t blocks) {
  // Quantiles of the studentized range with infinite degrees of freedom, divided by the root of 2. To 10 groups
  // Demsar's table 5 has the same, to 0.001.
  constexpr double q[]{1.960, 2.344, 2.569, 2.728, 2.850, 2.948, 3.031, 3.102, 3.164, 3.219,
                       3.268, 3.313, 3.354, 3.391, 3.426, 3.458, 3.489, 3.517, 3.544};
  if (groups - 2 >= std::size(q)) return unknown;
  return q[groups - 2] * std::sqrt(static_cast<double>(groups * (groups + 1)) / (6 * static_cast<double>(blocks)));
}

TestsOfAll tests_of_all(Observations observed) {
  TestsOfAll all;
  if (observed.scale == Scale::share || observed.are_logs) return all;
  std::erase_if(observed.groups, [&](const Group& group) {
    if (!has_chance(group)) all.without.push_back(group.name);
    return !has_chance(group);
  });
  const std::optional<TestOfAll> plain = anova(observed);
  for (const auto& test : {plain, anova_of_unequal(observed, plain)})
    if (test) all.tests.push_back(*test);
  return all;
}

}  // namespace ikbench::judge
