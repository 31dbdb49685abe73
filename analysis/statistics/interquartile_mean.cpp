#include "analysis/statistics/interquartile_mean.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/statistics/draw.hpp"
#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

constexpr int interquartile_resamples = 2000;

// All values in their order, and where in it each cluster's are.
struct Ordered {
  std::vector<double> values;
  std::vector<std::vector<std::vector<std::size_t>>> places;  // by stratum and cluster
};

Ordered ordered(std::span<const Stratum> strata) {
  std::vector<double> all;
  for (const Stratum& stratum : strata) {
    for (const Cluster& cluster : stratum) all.insert(all.end(), cluster.begin(), cluster.end());
  }
  std::ranges::replace_if(
      all, [](double value) { return std::isnan(value); }, worse_than_every_number);
  std::vector<std::size_t> order(all.size()), place(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return all[i]; });
  Ordered result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    result.values.push_back(all[order[i]]);
  }
  auto next = place.begin();
  for (const Stratum& stratum : strata) {
    auto& clusters = result.places.emplace_back();
    for (const Cluster& cluster : stratum) {
      clusters.emplace_back(next, next + static_cast<std::ptrdiff_t>(cluster.size()));
      next += static_cast<std::ptrdiff_t>(cluster.size());
    }
  }
  return result;
}

// Of sorted values that are there so often.
double middle_mean(const std::vector<double>& values, const std::vector<std::size_t>& counts) {
  const std::size_t n = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  const std::size_t first = n / 4, last = n - n / 4;
  double sum = 0;
  std::size_t before = 0;
  for (std::size_t i = 0; i < values.size() && before < last; ++i) {
    const std::size_t end = before + counts[i];
    const std::size_t from = std::max(before, first), to = std::min(end, last);
    if (from < to) sum += static_cast<double>(to - from) * values[i];
    before = end;
  }
  return sum / static_cast<double>(last - first);
}

std::string no_interval_because(std::span<const Stratum> strata, std::size_t values) {
  if (values > most_bootstrapped_values) return fmt::format("more than {} values", most_bootstrapped_values);
  const auto is_single = [](const Stratum& stratum) { return stratum.size() < 2; };
  return std::ranges::all_of(strata, is_single) ? "there is only one run" : "";
}

}  // namespace

InterquartileMean interquartile_mean(std::span<const Stratum> strata, double level) {
  check_level(level);
  const Ordered of = ordered(strata);
  InterquartileMean result;
  if (of.values.empty()) {
    result.undefined = "there are no values";
    return result;
  }
  std::vector<std::size_t> counts(of.values.size(), 1);
  result.estimate = middle_mean(of.values, counts);
  if (!std::isfinite(result.estimate)) {
    result.estimate = not_defined;
    result.undefined = "the middle half has values that are not finite";
    return result;
  }
  result.undefined = no_interval_because(strata, of.values.size());
  if (!result.undefined.empty()) return result;
  Draws draws(1);
  std::vector<double> means;
  for (int i = 0; i < interquartile_resamples; ++i) {
    std::ranges::fill(counts, std::size_t{0});
    for (const auto& clusters : of.places) {
      for (std::size_t drawn = 0; drawn < clusters.size(); ++drawn) {
        for (const std::size_t place : clusters[draws.below(clusters.size())]) ++counts[place];
      }
    }
    means.push_back(middle_mean(of.values, counts));
  }
  std::ranges::sort(means);
  const double low = quantile(means, (1 - level) / 2, QuantileType::type_7);
  const double high = quantile(means, (1 + level) / 2, QuantileType::type_7);
  if (!std::isfinite(low) || !std::isfinite(high)) {
    result.undefined = "the middle half has values that are not finite in some resamples";
    return result;
  }
  result.low = low;
  result.high = high;
  return result;
}

}  // namespace ikbench::statistics
