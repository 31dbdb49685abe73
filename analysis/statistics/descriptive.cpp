#include "analysis/statistics/descriptive.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::statistics {
namespace {

// Divided by n - 1, in the square of a unit.
struct Variance {
  double variance = not_defined;
  double unit = 1;
};

Variance variance_of(std::span<const double> values) {
  if (values.size() < 2) return {};
  const double unit = power_of_two_below(values);
  std::vector<double> scaled(values.begin(), values.end());
  for (double& value : scaled) value /= unit;
  const double variance = sum_of_squares(scaled) / static_cast<double>(values.size() - 1);
  const double size = std::ranges::max(scaled, {}, [](double value) { return std::abs(value); });
  const bool is_rounding = without_rounding(std::sqrt(variance), std::abs(size)) == 0;
  return {.variance = is_rounding ? 0.0 : variance, .unit = unit};
}

}  // namespace

std::string too_few_groups(std::size_t groups) {
  if (groups > 1) return {};
  return groups == 0 ? "no group to compare; two or more are needed" : "one group to compare; two or more are needed";
}

bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

double mean(std::span<const double> values) {
  if (values.empty()) return not_defined;
  const double shift = values.front();
  double sum = 0;
  for (const double value : values) sum += value - shift;
  const double result = shift + sum / static_cast<double>(values.size());
  if (std::isfinite(result)) return result;
  double shares = 0;  // the sum overflowed, or a value is not finite
  for (const double value : values) shares += value / static_cast<double>(values.size());
  return shares;
}

double sum_of_squares(std::span<const double> values) {
  if (values.empty()) return not_defined;
  const double shift = values.front();
  const double n = static_cast<double>(values.size());
  double shifted_mean = 0;
  for (const double value : values) shifted_mean += (value - shift) / n;
  double squares = 0;
  double rest = 0;  // the mean's rounding error (Chan, Golub, LeVeque 1983)
  for (const double value : values) {
    const double deviation = (value - shift) - shifted_mean;
    squares += deviation * deviation;
    rest += deviation;
  }
  return squares - rest * rest / n;
}

double power_of_two_below(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1.0;
}

double standard_deviation(std::span<const double> values) {
  const auto [variance, unit] = variance_of(values);
  return unit * std::sqrt(variance);
}

double standard_error(std::span<const double> values) {
  const auto [variance, unit] = variance_of(values);
  return unit * std::sqrt(variance / static_cast<double>(values.size()));
}

Description describe(std::span<const double> values) {
  Description result;
  result.n = static_cast<int>(values.size());
  const std::vector<double> ranked = ranked_values(values);
  const auto is_finite = [](double value) { return std::isfinite(value); };
  result.not_finite = result.n - static_cast<int>(std::ranges::count_if(ranked, is_finite));
  if (ranked.empty()) return result;
  result.median = quantile(ranked, 0.5, QuantileType::type_5);
  result.min = ranked.front();
  result.max = ranked.back();
  if (result.not_finite > 0) return result;
  result.mean = mean(values);
  result.std = standard_deviation(values);
  return result;
}

double median(std::span<const double> values) { return describe(values).median; }

GroupSummary summarise(std::span<const double> values) {
  GroupSummary result{.n = static_cast<int>(values.size())};
  if (!all_finite(values)) return result;
  result.mean = mean(values);
  result.std = standard_deviation(values);
  return result;
}

}  // namespace ikbench::statistics
