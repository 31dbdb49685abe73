#include "analysis/statistics/multiple_comparisons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

constexpr double root_two = boost::math::constants::root_two<double>();

std::vector<MeanDifference> differences(std::span<const GroupSummary> groups, std::optional<std::size_t> only_with) {
  if (only_with && *only_with >= groups.size()) {
    throw std::invalid_argument(
        fmt::format("comparisons with group {}: there are {} groups", *only_with, groups.size()));
  }
  std::vector<MeanDifference> pairs = pairs_of(groups.size(), only_with);
  for (MeanDifference& pair : pairs) pair.difference.value = groups[pair.first].mean - groups[pair.second].mean;
  return pairs;
}

// Says why a group cannot be compared; empty if it can.
Reason group_obstacle(const GroupSummary& group, std::size_t index) {
  if (group.n < 1) return {index, "{} has no values"};
  if (!std::isfinite(group.mean)) return {index, "{} has values that are not finite"};
  if (group.n > 1 && !(group.std >= 0)) return {index, "the spread of {} is not defined"};
  if (group.n > 1 && std::isinf(group.std)) {
    return {index, "the spread of {} is too large for double precision"};
  }
  return {};
}

// Adds the interval of a pair with q and p; `reach` is in standard errors.
void add_interval(MeanDifference& pair, double reach) {
  auto& [value, low, high] = pair.difference;
  low = value - reach * pair.standard_error;
  high = value + reach * pair.standard_error;
  if (std::isfinite(pair.q) && std::isfinite(pair.p) && std::isfinite(low) && std::isfinite(high)) return;
  pair.q = pair.p = pair.p_alone = low = high = not_defined;
  pair.undefined = "the difference or its spread is too large for double precision";
}

// Pairs with the standard errors and degrees of freedom of Welch's test, if these are defined.
std::vector<MeanDifference> with_own_variances(std::span<const GroupSummary> groups,
                                               std::optional<std::size_t> only_with) {
  std::vector<MeanDifference> pairs = differences(groups, only_with);
  for (MeanDifference& pair : pairs) {
    const GroupSummary& a = groups[pair.first];
    const GroupSummary& b = groups[pair.second];
    for (const std::size_t index : {pair.first, pair.second}) {
      if (pair.undefined.empty()) pair.undefined = group_obstacle(groups[index], index);
      if (pair.undefined.empty() && groups[index].n < 2) {
        pair.undefined = {index, "{} has a single value, so it has no spread"};
      }
    }
    if (pair.undefined.empty() && a.std == 0 && b.std == 0) pair.undefined = "both groups are constant";
    if (!pair.undefined.empty()) continue;
    const double a_error = a.std / std::sqrt(a.n);
    const double b_error = b.std / std::sqrt(b.n);
    pair.standard_error = std::hypot(a_error, b_error);
    const double a_part = std::pow(a_error / pair.standard_error, 4);
    const double b_part = std::pow(b_error / pair.standard_error, 4);
    pair.df = 1 / (a_part / (a.n - 1) + b_part / (b.n - 1));
  }
  return pairs;
}

}  // namespace

std::vector<MeanDifference> pairs_of(std::size_t groups, std::optional<std::size_t> only_with) {
  std::vector<MeanDifference> pairs;
  for (std::size_t first = 0; first < groups; ++first) {
    for (std::size_t second = first + 1; second < groups; ++second) {
      if (!only_with || first == *only_with || second == *only_with)
        pairs.push_back({.first = first, .second = second});
    }
  }
  return pairs;
}

std::vector<MeanDifference> tamhane(std::span<const GroupSummary> groups, double level,
                                    std::optional<std::size_t> only_with) {
  check_level(level);
  std::vector<MeanDifference> pairs = with_own_variances(groups, only_with);
  const auto k = static_cast<double>(groups.size());
  const double comparisons = k * (k - 1) / 2;
  const double tail = -std::expm1(std::log(level) / comparisons) / 2;  // of one side of one pair
  for (MeanDifference& pair : pairs) {
    if (!pair.undefined.empty()) continue;
    const double t = std::abs(pair.difference.value) / pair.standard_error;
    pair.q = t * root_two;
    pair.p_alone = 2 * t_upper_tail(t, pair.df);
    pair.p = -std::expm1(comparisons * std::log1p(-pair.p_alone));
    add_interval(pair, -t_quantile(tail, pair.df));
  }
  return pairs;
}

}  // namespace ikbench::statistics
