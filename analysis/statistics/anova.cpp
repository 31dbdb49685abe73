#include "analysis/statistics/anova.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ikbench::statistics {
namespace {

// A group's moments: its mean less a common shift, and its sum of squares.
struct Moments {
  double n = 0;
  double shifted_mean = 0;
  double squares = 0;
  double std = 0;
};

constexpr const char* too_large = "the sums of squares are too large for double precision";

AnovaTable from_moments(const std::vector<Moments>& groups) {
  AnovaTable table;
  table.df = table.df_within = 0;
  double n = 0;
  for (const Moments& group : groups) n += group.n;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].n < 1) {
      table.undefined = {i, "{} has no values"};
    } else if (std::isnan(groups[i].shifted_mean) || std::isnan(groups[i].std)) {
      table.undefined = {i, "{} has values that are not finite"};
    } else if (!std::isfinite(groups[i].shifted_mean) || !std::isfinite(groups[i].squares)) {
      table.undefined = too_large;
    }
    if (!table.undefined.empty()) return table;
  }
  table.undefined = too_few_groups(groups.size());
  if (!table.undefined.empty()) return table;

  table.df = static_cast<double>(groups.size()) - 1;
  table.df_within = n - static_cast<double>(groups.size());
  double grand_mean = 0;
  for (const Moments& group : groups) grand_mean += group.n / n * group.shifted_mean;
  table.ss_between = 0;
  table.ss_within = 0;
  for (const Moments& group : groups) {
    const double deviation = group.shifted_mean - grand_mean;
    table.ss_between += group.n * deviation * deviation;
    table.ss_within += group.squares;
  }
  table.ss_total = table.ss_between + table.ss_within;
  table.ms_between = table.ss_between / table.df;
  if (table.df_within < 1) {
    table.undefined = "every group has a single value, so there is no spread within groups to compare with";
    return table;
  }
  table.ms_within = table.ss_within / table.df_within;
  if (!(table.ms_within >= std::numeric_limits<double>::min())) {  // below it digits are lost
    const bool has_spread = std::ranges::any_of(groups, [](const Moments& group) { return group.std > 0; });
    table.undefined = has_spread ? "the spread within groups is too small for double precision"
                                 : "every group is constant, so there is no spread within groups to compare with";
    return table;
  }
  table.statistic = table.ms_between / table.ms_within;
  table.p = f_upper_tail(table.statistic, table.df, table.df_within);
  if (!std::isfinite(table.p)) table.undefined = too_large;
  return table;
}

}  // namespace

double f_upper_tail(double F, double df_between, double df_within) {
  if (!std::isfinite(F) || F < 0 || !(df_between >= 1) || !(df_within >= 1)) return not_defined;
  return boost::math::cdf(boost::math::complement(boost::math::fisher_f(df_between, df_within), F));
}

AnovaTable anova(std::span<const std::vector<double>> groups) {
  double shift = 0;
  for (const auto& group : groups) {
    if (group.empty()) continue;
    shift = group.front();
    break;
  }
  std::vector<Moments> moments;
  for (const auto& group : groups) {
    std::vector<double> shifted;
    shifted.reserve(group.size());
    for (const double value : group) shifted.push_back(value - shift);
    moments.push_back({.n = static_cast<double>(group.size()),
                       .shifted_mean = mean(shifted),
                       .squares = sum_of_squares(shifted),
                       .std = !all_finite(group)  ? not_defined
                              : group.size() == 1 ? 0.0
                                                  : standard_deviation(group)});
  }
  return from_moments(moments);
}

AnovaTable anova_from_summaries(std::span<const GroupSummary> groups) {
  std::vector<Moments> moments;
  for (const GroupSummary& group : groups) {
    const double std = group.n == 1 ? 0.0 : group.std;
    moments.push_back({.n = static_cast<double>(group.n),
                       .shifted_mean = group.mean,
                       .squares = (group.n - 1) * std * std,
                       .std = std});
  }
  return from_moments(moments);
}

}  // namespace ikbench::statistics
