#include "analysis/judge/statistics/pair_data.hpp"

#include <algorithm>

#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::judge {
namespace {

// The relative rounding of a double: smaller than a difference in the fifteenth digit, the last that every double
// keeps.
constexpr double rounding_of_doubles = 4 * std::numeric_limits<double>::epsilon();

// Makes values equal to the smallest value that lies below them by no more than the rounding of either.
void remove_rounding(std::vector<double>& values, const std::vector<double>& roundings) {
  const std::vector<IndexedValue> order = sorted_with_index(values);
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    const IndexedValue& least = order[first];
    const auto is_equal = [&](const IndexedValue& other) {
      return other.first <= least.first + std::max(roundings[least.second], roundings[other.second]);
    };
    // The loop starts behind the first value, because a NaN does not equal itself.
    for (next = first + 1; next < order.size() && is_equal(order[next]); ++next)
      values[order[next].second] = least.first;
  }
}

// Makes values equal that differ by no more than the rounding, or lie below the floor.
void settle(std::vector<double>& values, const MetricSamples& samples, bool has_floor) {
  std::vector<double> roundings;
  for (double& value : values) {
    value = has_floor ? std::max(value, floor_of(samples)) : value;
    // An infinite value stands for "no answer", so no number counts as equal to infinity.
    roundings.push_back(std::isinf(value) ? 0 : std::max(samples.resolution, rounding_of_doubles * std::abs(value)));
  }
  remove_rounding(values, roundings);
}

SummaryStatistics summary_of(const Group& group, const std::vector<double>& values) {
  if (const auto* const summary = std::get_if<SummaryStatistics>(&group.sample)) return *summary;
  return summarise(values);
}

bool is_one_value(const Group& group) {
  return values_of(group).size() == 1 || is_deterministic(group) || is_constant(group);
}

// Returns the differences of the values with the same place. A single value is compared with all values of the other
// group.
std::vector<double> differences_of(const Group& first, const Group& second, const PairData& numbers,
                                   bool is_log_scale) {
  std::vector<double> differences, sizes, roundings;
  const bool is_first_one = is_one_value(first), is_second_one = is_one_value(second);
  for (std::size_t i = 0; i < (is_first_one ? numbers.second : numbers.first).size(); ++i) {
    const double x = numbers.first[is_first_one ? 0 : i], y = numbers.second[is_second_one ? 0 : i];
    // The rounding depends only on these two values, so that a huge pair hides no difference of other pairs.
    const double rounding = rounding_of_doubles * std::max({is_log_scale ? 1.0 : 0.0, std::abs(x), std::abs(y)});
    const bool are_equal = std::abs(x - y) <= rounding;
    differences.push_back(x - y);
    sizes.push_back(are_equal ? 0 : std::abs(x - y));
    roundings.push_back(are_equal ? 0 : rounding);
  }
  remove_rounding(sizes, roundings);
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i] = std::copysign(sizes[i], differences[i]);
  return differences;
}

}  // namespace

void keep_common_blocks(const std::vector<Group*>& groups) {
  std::vector<Sample*> samples;
  for (Group* const group : groups)
    if (auto* const sample = std::get_if<Sample>(&group->sample)) samples.push_back(sample);
  const auto has_first_blocks = [&](const Sample* sample) { return sample->blocks == samples.front()->blocks; };
  if (std::ranges::all_of(samples, has_first_blocks)) return;
  std::vector<int> common = samples.front()->blocks;
  for (const Sample* const sample : samples)
    std::erase_if(common, [&](int block) { return !std::ranges::binary_search(sample->blocks, block); });
  for (Sample* const sample : samples) {
    auto block = sample->blocks.begin();
    std::erase_if(sample->values, [&](double) { return !std::ranges::binary_search(common, *block++); });
    sample->blocks = common;
  }
}

std::vector<std::vector<double>> settled_blocks(std::vector<Group> groups, const MetricSamples& samples,
                                                bool has_floor) {
  std::vector<Group*> pointers;
  for (Group& group : groups) pointers.push_back(&group);
  keep_common_blocks(pointers);
  std::vector<std::vector<double>> columns;
  for (const Group& group : groups) columns.emplace_back(values_of(group).begin(), values_of(group).end());
  for (std::size_t block = 0; block < columns.front().size(); ++block) {
    std::vector<double> values;
    for (const std::vector<double>& column : columns) values.push_back(column[block]);
    settle(values, samples, has_floor);
    for (std::size_t group = 0; group < columns.size(); ++group) columns[group][block] = values[group];
  }
  return columns;
}

PairData make_pair_data(const Group& first, const Group& second, const MetricSamples& samples, bool is_by_difference,
                        bool takes_logs) {
  const std::span<const double> of_first = values_of(first), of_second = values_of(second);
  std::vector<double> all(of_first.begin(), of_first.end());
  all.insert(all.end(), of_second.begin(), of_second.end());
  settle(all, samples, takes_logs);
  if (takes_logs) std::ranges::transform(all, all.begin(), [](double value) { return std::log(value); });
  PairData numbers;
  // The product of `far` and the largest value replaces infinity: no difference, mean or shift of finite values comes
  // near, and the square keeps all digits.
  constexpr double far = 1e4;
  double most = std::max(samples.absolute_margin, takes_logs ? 100.0 : 0.0);
  for (const double value : all) most = std::isinf(value) ? most : std::max(most, std::abs(value));
  for (double& value : all)
    if (std::isinf(value)) {
      numbers.infinity_substitute = most > 0 ? far * most : 1;
      value = std::copysign(numbers.infinity_substitute, value);
    }
  numbers.first.assign(all.begin(), all.begin() + std::ssize(of_first));
  numbers.second.assign(all.begin() + std::ssize(of_first), all.end());
  numbers.of_first = summary_of(first, numbers.first);
  numbers.of_second = summary_of(second, numbers.second);
  for (const Group* const group : {&first, &second}) {
    const Sample* const sample = sample_of(*group);
    if (sample == nullptr || sample->effective_n == 0) continue;
    numbers.effective_n = std::min(numbers.effective_n, sample->effective_n);
    numbers.solved_targets = std::min(numbers.solved_targets, sample->solved_targets);
  }
  if (is_by_difference) {
    numbers.differences = differences_of(first, second, numbers, takes_logs);
    numbers.are_all_equal = std::ranges::count(numbers.differences, 0.0) == std::ssize(numbers.differences);
  } else {
    numbers.are_all_equal = !all.empty() && std::ranges::count(all, all.front()) == std::ssize(all);
  }
  return numbers;
}

}  // namespace ikbench::judge
