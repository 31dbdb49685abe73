#include "analysis/judge/statistics/omnibus.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>

#include "analysis/judge/statistics/pair_data.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::judge {
namespace {

// Returns whether the values of a group were drawn by chance, and not by a deterministic solver.
bool has_chance(const Group& group) {
  return std::holds_alternative<SummaryStatistics>(group.sample) ||
         (!excluded(group) && !is_deterministic(group) && !values_of(group).empty());
}

OmnibusTest with_p(OmnibusTest test) {
  const boost::math::fisher_f distribution(test.df, test.df_within);
  test.p = boost::math::cdf(boost::math::complement(distribution, test.statistic));
  return test;
}

// Returns whether F exists: the groups need a spread that is more than rounding, and sums of squares that are finite.
bool has_f(const OmnibusTest& test) {
  return test.df_within >= 1 && test.ss_within > 1e-26 * test.ss_between && test.ss_within != 0 &&
         test.ss_between + test.ss_within < std::numeric_limits<double>::infinity();
}

OmnibusTest with_f(OmnibusTest test) {
  test.statistic = test.ss_between / test.df / (test.ss_within / test.df_within);
  return with_p(test);
}

// Returns the tests of repeated measures in the blocks that all groups have.
std::vector<OmnibusTest> anova_of_blocks(std::vector<Group> groups) {
  std::vector<Group*> pointers;
  for (Group& group : groups) pointers.push_back(&group);
  keep_common_blocks(pointers);
  std::vector<std::vector<double>> columns;
  for (Group& group : groups) columns.push_back(std::get<Sample>(group.sample).values);
  const std::size_t k = columns.size(), n = columns.front().size();
  if (n < 2) return {};
  // The common part of each block is subtracted before any sum. The common part decides nothing, and a huge part, such
  // as a penalty in all groups, would leave rounding in the sums.
  const std::vector<double> common = columns.front();
  std::vector<double> of_block(n), of_group(k);
  double mean = 0;
  for (std::size_t g = 0; g < k; ++g) {
    for (std::size_t i = 0; i < n; ++i) {
      const double value = columns[g][i] -= common[i];
      of_group[g] += value / static_cast<double>(n);
      of_block[i] += value / static_cast<double>(k);
    }
    mean += of_group[g] / static_cast<double>(k);
  }
  OmnibusTest test{.name = "ANOVA of repeated measures",
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
  double squares = 0;  // sum of the squared covariances of the residuals
  for (const auto& first : columns)
    for (const auto& second : columns)
      squares += std::pow(std::inner_product(first.begin(), first.end(), second.begin(), 0.0) / test.ss_within, 2);
  test.epsilon = 1 / (test.df * squares);
  if (!has_f(test)) return {};
  test = with_f(test);
  if (test.df < 2) return {test};
  return {test, with_p({.name = "Greenhouse-Geisser",
                        .statistic = test.statistic,
                        .df = test.df * test.epsilon,
                        .df_within = test.df_within * test.epsilon,
                        .epsilon = test.epsilon})};
}

// Returns the summaries of all groups, measured or printed. A common value is subtracted, because equal leading digits
// of all values would cost the sums precision.
std::vector<SummaryStatistics> summaries_of(const std::vector<Group>& groups) {
  const std::span<const double> of_first = values_of(groups.front());
  const double shift = of_first.empty() ? 0 : of_first.front();
  std::vector<SummaryStatistics> summaries;
  for (const Group& group : groups) {
    std::vector<double> shifted(values_of(group).begin(), values_of(group).end());
    for (double& value : shifted) value -= shift;
    const auto* const printed = std::get_if<SummaryStatistics>(&group.sample);
    summaries.push_back(printed ? *printed : summarise(shifted));
  }
  return summaries;
}

std::vector<OmnibusTest> anova_of_groups(const std::vector<SummaryStatistics>& groups) {
  const auto k = static_cast<double>(groups.size());
  double n = 0, sum = 0;
  for (const SummaryStatistics& group : groups) {
    n += group.n;
    sum += group.n * group.mean;
  }
  OmnibusTest test{.name = "ANOVA", .df = k - 1, .df_within = n - k, .ss_between = 0, .ss_within = 0};
  for (const SummaryStatistics& group : groups) {
    test.ss_between += group.n * (group.mean - sum / n) * (group.mean - sum / n);
    test.ss_within += (group.n - 1) * group.sd * group.sd;
  }
  if (!has_f(test)) return {};
  OmnibusTest welch{.name = "Welch's ANOVA", .statistic = 0, .df = k - 1};
  double weights = 0, mean = 0, lost = 0;
  const auto weight = [](const SummaryStatistics& group) { return group.n / (group.sd * group.sd); };
  for (const SummaryStatistics& group : groups) {
    if (group.n < 2 || !(group.sd > 0)) return {with_f(test)};
    weights += weight(group);
    mean += weight(group) * group.mean;
  }
  mean /= weights;
  for (const SummaryStatistics& group : groups) {
    lost += std::pow(1 - weight(group) / weights, 2) / (group.n - 1);
    welch.statistic += weight(group) * std::pow(group.mean - mean, 2) / welch.df;
  }
  welch.statistic /= 1 + 2 * (k - 2) / (k * k - 1) * lost;
  welch.df_within = (k * k - 1) / (3 * lost);
  return {with_f(test), with_p(welch)};
}

// Returns Friedman's chi-squared, corrected for ties. NaN if all values of each block are equal.
double friedman_statistic(const std::vector<std::span<const double>>& groups) {
  const std::size_t blocks = groups.front().size();
  const auto k = static_cast<double>(groups.size()), n = static_cast<double>(blocks);
  std::vector<double> rank_sums(groups.size());
  double ties = 0;  // the sum of t^3 - t over all ties of t values
  for (std::size_t block = 0; block < blocks; ++block) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const double value = groups[g][block];
      double smaller = 0, equal = 0;
      for (const std::span<const double> other : groups) {
        smaller += other[block] < value ? 1 : 0;
        equal += other[block] == value ? 1 : 0;
      }
      rank_sums[g] += smaller + (equal + 1) / 2;
      ties += equal * equal - 1;  // each of t equal values adds its share of t^3 - t
    }
  }
  double squares = 0;
  for (const double sum : rank_sums) squares += (sum - n * (k + 1) / 2) * (sum - n * (k + 1) / 2);
  const double spread = n * k * (k + 1) - ties / (k - 1);
  return spread > 1e-9 ? 12 * squares / spread : unknown;
}

double p_of_chi_squared(double statistic, double df) {
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(df), statistic));
}

}  // namespace

std::vector<OmnibusTest> anova(const MetricSamples& samples) {
  if (samples.groups.size() < 2 || !std::ranges::all_of(samples.groups, has_chance)) return {};
  return samples.is_paired ? anova_of_blocks(samples.groups) : anova_of_groups(summaries_of(samples.groups));
}

std::vector<OmnibusTest> friedman(const MetricSamples& samples) {
  std::vector<Group> groups = samples.groups;
  const auto has_values = [](const Group& group) { return sample_of(group) && !values_of(group).empty(); };
  if (!samples.is_paired || is_log_scale(samples) || groups.size() < 3 || !std::ranges::all_of(groups, has_values))
    return {};
  std::vector<Group*> pointers;
  for (Group& group : groups) pointers.push_back(&group);
  keep_common_blocks(pointers);
  std::vector<std::span<const double>> columns;
  for (const Group& group : groups) columns.push_back(values_of(group));
  const auto k = static_cast<double>(columns.size()), n = static_cast<double>(columns.front().size());
  if (n < 2) return {};
  OmnibusTest test{.name = friedman_name, .statistic = friedman_statistic(columns), .df = k - 1};
  if (std::isnan(test.statistic)) return {};
  test.p = p_of_chi_squared(test.statistic, test.df);
  OmnibusTest iman_davenport{.name = iman_davenport_name, .df = k - 1, .df_within = (k - 1) * (n - 1)};
  iman_davenport.statistic = (n - 1) * test.statistic / (n * (k - 1) - test.statistic);
  if (!(iman_davenport.statistic >= 0) || std::isinf(iman_davenport.statistic)) return {test};  // all blocks agree
  return {test, with_p(iman_davenport)};
}

double friedman_p(const std::vector<std::span<const double>>& groups) {
  const double statistic = friedman_statistic(groups);
  return std::isnan(statistic) ? 1 : p_of_chi_squared(statistic, static_cast<double>(groups.size() - 1));
}

double critical_difference(std::size_t groups, std::size_t blocks) {
  // The numbers are quantiles of the studentized range with infinite degrees of freedom, divided by the root of 2. For
  // up to 10 groups, Demsar's table 5 has the same numbers to 0.001.
  constexpr double q[]{1.960, 2.344, 2.569, 2.728, 2.850, 2.948, 3.031, 3.102, 3.164, 3.219,
                       3.268, 3.313, 3.354, 3.391, 3.426, 3.458, 3.489, 3.517, 3.544};
  if (groups - 2 >= std::size(q)) return unknown;
  return q[groups - 2] * std::sqrt(static_cast<double>(groups * (groups + 1)) / (6 * static_cast<double>(blocks)));
}

OmnibusTests omnibus_tests(MetricSamples samples) {
  OmnibusTests all;
  if (is_proportion(samples) || is_log_scale(samples)) return all;
  std::erase_if(samples.groups, [&](const Group& group) {
    if (!has_chance(group)) all.without.push_back(group.name);
    return !has_chance(group);
  });
  all.tests = anova(samples);
  return all;
}

}  // namespace ikbench::judge
