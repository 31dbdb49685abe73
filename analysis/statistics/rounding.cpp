#include "analysis/statistics/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

namespace ikbench::statistics {

double without_rounding(double difference, double size) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * size;
  return std::abs(difference) <= rounding ? 0.0 : difference;
}

std::vector<double> without_rounding(std::span<const double> numbers, std::span<const double> sizes) {
  std::vector<double> result(numbers.begin(), numbers.end());
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !std::isfinite(numbers[i]) || !std::isfinite(sizes[i]); });
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(sizes[i], std::abs(numbers[i])); });
  std::set<double> different{0};  // magnitudes, those of the most exact numbers first
  for (const std::size_t i : order) {
    const double magnitude = std::abs(numbers[i]);
    const auto above = different.lower_bound(magnitude);
    double nearest = above == different.end() ? *std::prev(above) : *above;
    if (above != different.begin() && magnitude - *std::prev(above) < std::abs(nearest - magnitude)) {
      nearest = *std::prev(above);
    }
    if (without_rounding(magnitude - nearest, sizes[i]) == 0) {
      result[i] = nearest == 0 ? 0.0 : std::copysign(nearest, numbers[i]);
    } else {
      different.insert(magnitude);
    }
  }
  return result;
}

// As above, where each number is its own size: the nearest of those before is the last of them.
std::vector<double> without_rounding(std::span<const double> values) {
  std::vector<double> result(values.begin(), values.end());
  std::vector<double*> order;
  order.reserve(result.size());
  for (double& value : result) {
    if (std::isfinite(value)) order.push_back(&value);
  }
  std::ranges::sort(order, {}, [](const double* value) { return std::abs(*value); });
  double last = 0;
  for (double* value : order) {
    const double magnitude = std::abs(*value);
    if (without_rounding(magnitude - last, magnitude) == 0) {
      *value = last == 0 ? 0.0 : std::copysign(last, *value);
    } else {
      last = magnitude;
    }
  }
  return result;
}

std::vector<double> differences_without_rounding(std::span<const double> first, std::span<const double> second) {
  std::vector<double> differences, sizes;
  for (std::size_t i = 0; i < first.size(); ++i) {
    differences.push_back(first[i] - second[i]);
    sizes.push_back(std::max(std::abs(first[i]), std::abs(second[i])));
  }
  return without_rounding(differences, sizes);
}

}  // namespace ikbench::statistics
