#include "analysis/judge/prepare.hpp"

#include <algorithm>
#include <utility>

#include "analysis/judge/tests_of_two.hpp"

namespace ikbench::judge {
namespace {

// Relative: smaller than a difference in the fifteenth digit, the last that every double can tell.
constexpr double rounding_of_doubles = 4 * std::numeric_limits<double>::epsilon();

// Makes values equal that lie within the rounding above the smallest of them: the metric's, or that of doubles.
void remove_rounding(std::vector<double>& values, double rounding) {
  std::vector<std::pair<double, double*>> order;  // pairs stay in the cache, which places alone would not
  order.reserve(values.size());
  for (double& value : values) order.emplace_back(value, &value);
  std::ranges::sort(order, {}, &std::pair<double, double*>::first);
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    const double least = order[first].first, most = least + std::max(rounding, rounding_of_doubles * std::abs(least));
    for (; next < order.size() && order[next].first <= most; ++next) *order[next].second = least;
  }
}

bool is_one_value(const Group& group) {
  const auto* const measured = std::get_if<Measured>(&group.sample);
  return measured == nullptr || measured->may_repeat || measured->values.size() == 1;
}

Summary summary_of(const Group& group, const std::vector<double>& values) {
  if (const auto* const summary = std::get_if<Summary>(&group.sample)) return *summary;
  return summarise(values);
}

std::vector<double> differences_of(const Group& first, const Group& second, const Prepared& numbers, bool are_logs) {
  std::vector<double> differences, sizes{0};
  double largest = are_logs ? 1 : 0;
  const bool is_one_of_first = is_one_value(first), is_one_of_second = is_one_value(second);
  const std::size_t n = is_one_of_first ? numbers.second.size() : numbers.first.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double x = numbers.first[is_one_of_first ? 0 : i], y = numbers.second[is_one_of_second ? 0 : i];
    differences.push_back(x - y);
    sizes.push_back(std::abs(x - y));
    largest = std::max({largest, std::abs(x), std::abs(y)});
  }
  remove_rounding(sizes, rounding_of_doubles * largest);
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i] = std::copysign(sizes[i + 1], differences[i]);
  return differences;
}

}  // namespace

std::vector<double> values_in(const std::vector<int>& blocks, const Measured& group) {
  if (group.blocks.empty()) return group.values;
  std::vector<double> values;
  for (std::size_t i = 0; i < group.blocks.size(); ++i) {
    if (std::ranges::binary_search(blocks, group.blocks[i])) values.push_back(group.values[i]);
  }
  return values;
}

void settle(std::vector<double>& values, const Observations& observed, bool has_floor) {
  for (double& value : values) value = has_floor ? std::max(value, observed.floor) : value;
  remove_rounding(values, observed.rounding);
}

Prepared prepared(const Group& first, const Group& second, const Observations& observed, bool is_by_difference,
                  bool takes_logs) {
  const std::span<const double> of_first = values_of(first), of_second = values_of(second);
  std::vector<double> all(of_first.begin(), of_first.end());
  all.insert(all.end(), of_second.begin(), of_second.end());
  settle(all, observed, takes_logs);
  if (takes_logs) std::ranges::transform(all, all.begin(), [](double value) { return std::log(value); });
  Prepared numbers;
  // A stand-in that no difference, mean or shift of the others comes near, and whose square is still exact enough.
  constexpr double far = 1e4;
  double most = std::max(observed.absolute_margin, takes_logs ? 100.0 : 0.0);
  for (const double value : all) most = std::isinf(value) ? most : std::max(most, std::abs(value));
  for (double& value : all) {
    if (std::isinf(value)) value = numbers.no_answer = most > 0 ? far * most : 1;
  }
  numbers.first.assign(all.begin(), all.begin() + std::ssize(of_first));
  numbers.second.assign(all.begin() + std::ssize(of_first), all.end());
  numbers.of_first = summary_of(first, numbers.first);
  numbers.of_second = summary_of(second, numbers.second);
  if (is_by_difference) {
    numbers.differences = differences_of(first, second, numbers, takes_logs);
    numbers.are_all_equal = std::ranges::count(numbers.differences, 0.0) == std::ssize(numbers.differences);
  } else {
    numbers.are_all_equal = !all.empty() && std::ranges::count(all, all.front()) == std::ssize(all);
  }
  return numbers;
}

}  // namespace ikbench::judge
