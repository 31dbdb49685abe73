#include "analysis/statistics/bootstrap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/draw.hpp"
#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

void check(const Resampling& settings) {
  check_level(settings.level);
  if (settings.resamples < 2) {
    throw std::invalid_argument(fmt::format("{} resamples: expected 2 or more", settings.resamples));
  }
}

// The number of standard deviations of the replicates that reach as far as Student's t does where the normal
// distribution has z: t for the degrees of freedom, and n by n - 1 because replicates vary as if their mean were known.
double expanded(double z, std::size_t clusters) {
  const auto n = static_cast<double>(clusters);
  return std::sqrt(n / (n - 1)) * t_quantile(1 - normal_two_sided(z) / 2, n - 1);
}

}  // namespace

std::vector<std::vector<double>> resampled_clusters(std::size_t clusters, const Resampling& settings) {
  check(settings);
  if (clusters == 0) throw std::invalid_argument("no clusters to draw: expected 1 or more");
  Draws draws(settings.seed);
  std::vector<std::vector<double>> replicates(static_cast<std::size_t>(settings.resamples),
                                              std::vector<double>(clusters));
  for (std::vector<double>& drawn : replicates) {
    for (std::size_t i = 0; i < clusters; ++i) ++drawn[draws.below(clusters)];
  }
  return replicates;
}

Estimate expanded_percentiles(double estimate, std::vector<double> replicates, std::size_t clusters, double level) {
  check_level(level);
  const auto is_nan = [](double value) { return std::isnan(value); };
  if (clusters < 2 || replicates.empty() || std::ranges::any_of(replicates, is_nan)) return {.value = estimate};
  const double outside = normal_two_sided(expanded(normal_critical(level), clusters)) / 2;
  const auto last = static_cast<std::ptrdiff_t>(replicates.size()) - 1;
  const auto skipped = static_cast<std::ptrdiff_t>(outside * static_cast<double>(last));
  const auto at = [&](std::ptrdiff_t rank) {
    const auto place = replicates.begin() + rank;
    std::ranges::nth_element(replicates, place);
    return *place;
  };
  return {.value = estimate, .low = at(skipped), .high = at(last - skipped)};
}

std::vector<Estimate> simultaneous_intervals(std::span<const double> estimates,
                                             std::span<const std::vector<double>> replicates, std::size_t clusters,
                                             double level) {
  check_level(level);
  std::vector<double> spreads, largest;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const double spread = standard_deviation(replicates[i]);
    spreads.push_back(std::isfinite(estimates[i] + spread) ? spread : not_defined);
    largest.resize(std::max(largest.size(), replicates[i].size()));
    if (!(spreads.back() > 0)) continue;
    for (std::size_t b = 0; b < replicates[i].size(); ++b) {
      largest[b] = std::max(largest[b], std::abs(replicates[i][b] - estimates[i]) / spread);
    }
  }
  std::vector<Estimate> result;
  for (const double estimate : estimates) result.push_back({.value = estimate});
  if (clusters < 2 || largest.empty()) return result;
  std::ranges::sort(largest);
  const double critical = expanded(quantile(largest, level, QuantileType::type_7), clusters);
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    if (std::isnan(spreads[i])) continue;
    const double half = spreads[i] > 0 ? critical * spreads[i] : 0;
    result[i].low = estimates[i] - half;
    result[i].high = estimates[i] + half;
  }
  return result;
}

}  // namespace ikbench::statistics
