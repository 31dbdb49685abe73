#include "analysis/statistics/effect_size.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

// For each value of a, the share of values of b below it less the share above it; and the share of tied pairs (one of
// a, one of b). Requires sorted samples.
std::pair<std::vector<double>, double> dominances(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> rows;
  const auto m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  auto first = b.begin(), last = b.begin();  // the values of b that equal a value of a
  double ties = 0;
  for (const double value : a) {
    while (first != b.end() && *first < value) ++first;
    while (last != b.end() && !(value < *last)) ++last;
    rows.push_back(static_cast<double>((first - b.begin()) - (b.end() - last)) / n);
    ties += static_cast<double>(last - first);
  }
  return {rows, ties / (m * n)};
}

// Returns delta and its variance by Cliff (1993), the consistent estimate:
// ((n - 1) s_row^2 + (m - 1) s_column^2 + s_pair^2) / (m n).
std::pair<double, double> dominance(std::span<const double> a, std::span<const double> b) {
  std::vector<double> sorted_a(a.begin(), a.end()), sorted_b(b.begin(), b.end());
  std::ranges::sort(sorted_a);
  std::ranges::sort(sorted_b);
  const auto [rows, tied] = dominances(sorted_a, sorted_b);
  const std::vector<double> columns = dominances(sorted_b, sorted_a).first;
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size()), delta = mean(rows);
  const double pairs = (1 - tied - delta * delta) * m * n;  // sum of (d_ij - delta)^2
  const double of_means = (n - 1) / (m - 1) * sum_of_squares(rows) + (m - 1) / (n - 1) * sum_of_squares(columns);
  return {delta, (of_means + std::max(0.0, pairs) / ((m - 1) * (n - 1))) / (m * n)};
}

double finite(double value) { return std::isfinite(value) ? value : not_defined; }

}  // namespace

double omega_squared(const AnovaTable& table) {
  return finite((table.ss_between - table.df * table.ms_within) / (table.ss_total + table.ms_within));
}

double hedges_g(const GroupSummary& a, const GroupSummary& b) {
  if (a.n < 2 || b.n < 2) return not_defined;
  const double df = a.n - 1.0 + b.n - 1.0;
  const double pooled = std::hypot(a.std * std::sqrt((a.n - 1) / df), b.std * std::sqrt((b.n - 1) / df));
  const double correction = boost::math::tgamma_delta_ratio(df / 2, -0.5) / std::sqrt(df / 2);
  return std::isfinite(pooled) ? finite((a.mean - b.mean) / pooled * correction) : not_defined;
}

Estimate cliffs_delta(std::span<const double> a, std::span<const double> b, double level) {
  check_level(level);
  const auto is_nan = [](double value) { return std::isnan(value); };
  if (a.empty() || b.empty() || std::ranges::any_of(a, is_nan) || std::ranges::any_of(b, is_nan)) return {};
  const auto [delta, variance] = dominance(a, b);
  Estimate effect{.value = delta};
  if (a.size() < 2 || b.size() < 2) return effect;
  const double z = normal_critical(level);
  if (std::abs(delta) == 1) {
    const double n = static_cast<double>(std::min(a.size(), b.size()));
    const double limit = (n - z * z) / (n + z * z);
    effect.low = delta > 0 ? limit : -1;
    effect.high = delta > 0 ? 1 : -limit;
  } else if (variance > 0) {
    const double below_one = 1 - delta * delta;
    const double reach = z * std::sqrt(variance * (below_one * below_one + z * z * variance));
    const double scale = below_one + z * z * variance;
    effect.low = std::clamp((delta * below_one - reach) / scale, -1.0, 1.0);
    effect.high = std::clamp((delta * below_one + reach) / scale, -1.0, 1.0);
  }
  return effect;
}

Estimate vargha_delaney(std::span<const double> a, std::span<const double> b, double level) {
  Estimate effect = cliffs_delta(a, b, level);
  for (double* value : {&effect.value, &effect.low, &effect.high}) *value = (*value + 1) / 2;
  return effect;
}

}  // namespace ikbench::statistics
