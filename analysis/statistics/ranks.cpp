#include "analysis/statistics/ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace ikbench::statistics {

double Ranking::tie_sum() const {
  double sum = 0;
  for (const std::size_t tie : ties) {
    const auto t = static_cast<double>(tie);
    sum += t * t * t - t;
  }
  return sum;
}

Ranking midranks(std::span<const double> values) {
  Ranking ranking;
  if (std::ranges::any_of(values, [](double value) { return std::isnan(value); })) {
    ranking.undefined = "a value is not a number and has no rank";
    return ranking;
  }
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });  // merge sort: fast if sorted
  ranking.ranks.resize(values.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    const double shared = static_cast<double>(first + 1 + end) / 2;  // the mean of ranks first + 1 to end
    for (std::size_t i = first; i < end; ++i) ranking.ranks[order[i]] = shared;
    if (end - first > 1) ranking.ties.push_back(end - first);
  }
  return ranking;
}

Ranking midranks(std::span<const double> first, std::span<const double> second) {
  std::vector<double> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  return midranks(all);
}

std::vector<double> pooled(std::span<const std::vector<double>> groups) {
  std::vector<double> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace ikbench::statistics
