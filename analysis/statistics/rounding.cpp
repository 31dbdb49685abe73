#include "analysis/statistics/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>

namespace ikbench::statistics {

double without_rounding(double difference, double size) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * size;
  return std::abs(difference) <= rounding ? 0.0 : difference;
}

namespace {

struct Sized {
  double magnitude;
  double size;
  double* number;
};

// Joins numbers near each other: the most exact first, each becomes equal to the nearest earlier one, if it can.
void join(std::span<Sized> near, std::set<double> different) {
  std::ranges::sort(near, {}, [](const Sized& each) { return std::tuple(each.size, each.magnitude); });
  for (const auto& [magnitude, size, number] : near) {
    const auto above = different.lower_bound(magnitude);
    double nearest = above == different.end() ? std::numeric_limits<double>::infinity() : *above;
    if (above != different.begin() && magnitude - *std::prev(above) < std::abs(nearest - magnitude)) {
      nearest = *std::prev(above);
    }
    if (without_rounding(magnitude - nearest, size) == 0) {
      *number = nearest == 0 ? 0.0 : std::copysign(nearest, *number);
    } else {
      different.insert(magnitude);
    }
  }
}

}  // namespace

std::vector<double> without_rounding(std::span<const double> numbers, std::span<const double> sizes) {
  std::vector<double> result(numbers.begin(), numbers.end());
  std::vector<Sized> order;
  order.reserve(result.size());
  double largest = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!std::isfinite(numbers[i]) || !std::isfinite(sizes[i])) continue;
    order.push_back({std::abs(numbers[i]), sizes[i], &result[i]});
    largest = std::max(largest, sizes[i]);
  }
  std::ranges::sort(order, {}, &Sized::magnitude);
  const auto is_far = [largest](double below, double above) { return without_rounding(above - below, largest) != 0; };
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    for (end = first + 1; end < order.size() && !is_far(order[end - 1].magnitude, order[end].magnitude);) ++end;
    const bool is_at_zero = first == 0 && !is_far(0, order.front().magnitude);
    if (order[first].magnitude == order[end - 1].magnitude && !is_at_zero) continue;
    join(std::span(order).subspan(first, end - first), is_at_zero ? std::set<double>{0} : std::set<double>{});
  }
  return result;
}

std::vector<double> without_rounding(std::span<const double> values) {
  std::vector<double> sizes;
  for (const double value : values) sizes.push_back(std::abs(value));
  return without_rounding(values, sizes);
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
