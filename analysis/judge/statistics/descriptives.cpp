#include "analysis/judge/statistics/descriptives.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace ikbench::judge {

double quantile(const std::vector<double>& sorted, double share) {
  const auto n = static_cast<double>(sorted.size());
  const double place = std::clamp(n * share - 0.5, 0.0, n - 1), part = place - std::floor(place);
  const double low = sorted[static_cast<std::size_t>(place)];
  const double high = sorted[std::min(static_cast<std::size_t>(place) + 1, sorted.size() - 1)];
  return low == high || part == 0 ? low : (1 - part) * low + part * high;
}

Descriptives describe_values(const std::vector<double>& values) {
  if (values.empty()) return {};
  const SummaryStatistics summary = summarise(values);
  std::vector<double> sorted = values;
  if (!std::ranges::is_sorted(sorted)) std::ranges::sort(sorted);
  const bool is_finite = std::isfinite(sorted.front()) && std::isfinite(sorted.back());
  const double infinite = std::isfinite(sorted.back()) ? sorted.front() : sorted.back();
  return {.n = summary.n,
          .mean = is_finite ? summary.mean : infinite,
          .sd = summary.n > 1 && is_finite ? summary.sd : unknown,
          .median = quantile(sorted, 0.5),
          .lower_quartile = quantile(sorted, 0.25),
          .upper_quartile = quantile(sorted, 0.75),
          .quantile_95 = quantile(sorted, 0.95),
          .smallest = sorted.front(),
          .largest = sorted.back()};
}

Descriptives describe(const Group& group) {
  const auto* printed = std::get_if<SummaryStatistics>(&group.sample);
  if (excluded(group) && excluded(group)->printed) printed = &*excluded(group)->printed;
  if (printed) return {.n = printed->n, .mean = printed->mean, .sd = printed->sd};
  const std::span<const double> values = values_of(group);
  Descriptives descriptives = describe_values({values.begin(), values.end()});
  if (group.tolerance > 0) descriptives.sd = unknown;
  return descriptives;
}

std::optional<double> hedges_g(const SummaryStatistics& first, const SummaryStatistics& second) {
  const double df = first.n + second.n - 2;
  const double squares = (first.n - 1) * first.sd * first.sd + (second.n - 1) * second.sd * second.sd;
  if (!(squares > 0) || !(df > 1)) return {};
  const double unbiased = std::exp(std::lgamma(df / 2) - std::lgamma((df - 1) / 2)) / std::sqrt(df / 2);
  return unbiased * (first.mean - second.mean) / std::sqrt(squares / df);
}

}  // namespace ikbench::judge
