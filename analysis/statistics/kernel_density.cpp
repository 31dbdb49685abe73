#include "analysis/statistics/kernel_density.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::statistics {
namespace {

constexpr std::size_t grid_points = 256;
constexpr std::size_t fewest_values = 5;

// How much of the sample is at each point of the grid: a value is shared by its two neighbours, as near as they are.
std::vector<double> binned(std::span<const double> values, double step) {
  std::vector<double> shares(grid_points);
  for (const double value : values) {
    const double position = std::clamp(value / step, 0.0, static_cast<double>(grid_points - 1));
    const auto lower = std::min(static_cast<std::size_t>(position), grid_points - 2);
    const double upper_share = position - static_cast<double>(lower);
    shares[lower] += (1 - upper_share) / static_cast<double>(values.size());
    shares[lower + 1] += upper_share / static_cast<double>(values.size());
  }
  return shares;
}

}  // namespace

double silverman_bandwidth(std::span<const double> values) {
  const std::vector<double> ranked = ranked_values(values);
  const double box =
      (quantile(ranked, 0.75, QuantileType::type_7) - quantile(ranked, 0.25, QuantileType::type_7)) / 1.34;
  const double spread = summarise(values).std;
  const double narrower = box > 0 ? std::min(spread, box) : spread;
  return narrower > 0 ? 0.9 * narrower * std::pow(static_cast<double>(values.size()), -0.2) : 0;
}

std::vector<DensityPoint> kernel_density(std::span<const double> values) {
  if (values.size() < fewest_values) return {};
  const auto [low, high] = std::ranges::minmax(values);
  const double range = high - low;
  if (!(range > 0 && std::isfinite(range))) return {};
  // In units of the range, in which no square overflows.
  std::vector<double> scaled;
  for (const double value : values) scaled.push_back((value - low) / range);
  constexpr double step = 1.0 / static_cast<double>(grid_points - 1);
  // A kernel narrower than the grid would fall between its points.
  const double bandwidth = std::max(silverman_bandwidth(scaled), step);
  const std::vector<double> shares = binned(scaled, step);
  std::vector<DensityPoint> result(grid_points);
  for (std::size_t i = 0; i < grid_points; ++i) {
    result[i].value = i + 1 < grid_points ? low + range * step * static_cast<double>(i) : high;
    for (std::size_t j = 0; j < grid_points; ++j) {
      const double z = step * (static_cast<double>(i) - static_cast<double>(j)) / bandwidth;
      result[i].density += shares[j] * std::exp(-z * z / 2);
    }
    result[i].density /= bandwidth * std::sqrt(2 * std::numbers::pi) * range;
  }
  return result;
}

}  // namespace ikbench::statistics
