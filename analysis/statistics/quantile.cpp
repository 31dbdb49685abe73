#include "analysis/statistics/quantile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

std::vector<double> ranked_values(std::span<const double> values) {
  std::vector<double> ranked(values.begin(), values.end());
  for (double& value : ranked) {
    if (std::isnan(value)) value = worse_than_every_number;
  }
  std::ranges::sort(ranked);
  return ranked;
}

namespace {

// Weight of the upper neighbour if the position j + g falls between two order statistics.
double weight(QuantileType type, double j, double g) {
  const bool between = g > 0;
  switch (type) {
    case QuantileType::type_1:
      return between ? 1.0 : 0.0;
    case QuantileType::type_2:
      return between ? 1.0 : 0.5;
    case QuantileType::type_3:
      return !between && std::fmod(j, 2.0) == 0.0 ? 0.0 : 1.0;
    default:
      return g;
  }
}

// m = a + p (1 - a - b), Hyndman and Fan's plotting positions.
double offset(QuantileType type, double p) {
  constexpr std::array<std::array<double, 2>, 6> ab{
      {{0, 1}, {0.5, 0.5}, {0, 0}, {1, 1}, {1.0 / 3, 1.0 / 3}, {3.0 / 8, 3.0 / 8}}};
  if (type == QuantileType::type_3) return -0.5;
  if (type < QuantileType::type_4) return 0;
  const auto [a, b] = ab[static_cast<std::size_t>(type) - 4];
  return a + p * (1 - a - b);
}

}  // namespace

double quantile(std::span<const double> sorted, double p, QuantileType type) {
  if (!(p >= 0 && p <= 1)) throw std::invalid_argument(fmt::format("quantile at p = {}: expected 0 to 1", p));
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double n = static_cast<double>(sorted.size());
  const double position = n * p + offset(type, p);
  const double fuzz = 4 * std::numeric_limits<double>::epsilon() * std::max(1.0, n);  // n p is rarely exact in binary
  const double j = std::floor(position + fuzz);
  const double g = position - j < fuzz ? 0.0 : position - j;
  const auto order_statistic = [&](double rank) {
    return sorted[static_cast<std::size_t>(std::clamp(rank, 1.0, n)) - 1];
  };
  const double lower = order_statistic(j);
  const double upper = order_statistic(j + 1);
  const double w = weight(type, j, g);
  if (w == 0 || lower == upper) return lower;
  if (w == 1) return upper;
  return (1 - w) * lower + w * upper;
}

double decades(std::span<const double> values) {
  const std::vector<double> ranked = ranked_values(values);
  const double low = quantile(ranked, 0.05, QuantileType::type_7), high = quantile(ranked, 0.95, QuantileType::type_7);
  return low > 0 && std::isfinite(high) ? std::log10(high / low) : not_defined;
}

Estimate median_interval(std::span<const double> sorted, double level) {
  check_level(level);
  const std::size_t n = sorted.size();
  const Estimate alone{.value = quantile(sorted, 0.5, QuantileType::type_5)};
  if (std::ldexp(2.0, -static_cast<int>(std::min<std::size_t>(n, 1000))) > 1 - level) return alone;
  // P(fewer than `rank` values lie below the median)
  const auto missed = [&](std::size_t rank) {
    return boost::math::cdf(boost::math::binomial(static_cast<double>(n), 0.5), static_cast<double>(rank - 1));
  };
  std::size_t rank = 1, too_far = n / 2 + 1;
  while (too_far - rank > 1) {
    const std::size_t middle = rank + (too_far - rank) / 2;
    (2 * missed(middle) <= 1 - level ? rank : too_far) = middle;
  }
  return {.value = alone.value, .low = sorted[rank - 1], .high = sorted[n - rank]};
}

}  // namespace ikbench::statistics
