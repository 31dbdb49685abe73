#include "analysis/statistics/bootstrap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/statistics/draw.hpp"
#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/t_distribution.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

constexpr std::size_t most_left_out = 1000;  // values of a sample that the acceleration leaves out in turn

std::string too_few(std::size_t values) {
  if (values > 1) return {};
  return values == 0 ? "a sample has no values" : "a sample of one value cannot be resampled";
}

// Efron's acceleration from the statistic without each value in turn (Davison and Hinkley, section 5.3.2). Of a large
// sample a thousand values, evenly spaced, stand for all, so that the work does not grow with the square.
double acceleration(std::span<const double> sample, const Statistic& statistic) {
  const std::size_t left_out = std::min(sample.size(), most_left_out);
  std::vector<double> influences;
  for (std::size_t i = 0; i < left_out; ++i) {
    std::vector<double> rest(sample.begin(), sample.end());
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>((2 * i + 1) * sample.size() / (2 * left_out)));
    influences.push_back(statistic(rest));
  }
  const double centre = mean(influences);
  const auto n = static_cast<double>(sample.size());
  for (double& influence : influences) influence = (n - 1) / n * (centre - influence);
  const double unit = power_of_two_below(influences);  // the acceleration has none
  const double stands_for = n / static_cast<double>(left_out);
  double squares = 0, cubes = 0;
  for (const double influence : influences) {
    const double scaled = influence / unit;
    squares += stands_for * scaled * scaled;
    cubes += stands_for * scaled * scaled * scaled;
  }
  return cubes / (6 * squares * std::sqrt(squares));
}

// Fills in the intervals from the sorted resamples; estimate and acceleration are there.
void judge(BootstrapInterval& result, std::vector<double> resampled, double level) {
  if (!std::isfinite(result.estimate)) {
    result.undefined = "the statistic is not finite";
  } else if (!std::ranges::all_of(resampled, [](double value) { return std::isfinite(value); })) {
    result.undefined = "the statistic is not finite on some resamples";
  }
  const double spread = standard_deviation(resampled);
  if (result.undefined.empty() && !std::isfinite(spread)) {
    result.undefined = "the spread is too large for double precision";
  }
  result.bca_undefined = result.undefined;
  if (!result.undefined.empty()) return;

  std::ranges::sort(resampled);
  const double outside = (1 - level) / 2;
  result.standard_error = spread;
  result.low = quantile(resampled, outside, QuantileType::type_7);
  result.high = quantile(resampled, 1 - outside, QuantileType::type_7);

  const auto below = std::ranges::lower_bound(resampled, result.estimate) - resampled.begin();
  result.z0 = normal_quantile(static_cast<double>(below) / static_cast<double>(resampled.size()));
  if (resampled.front() == resampled.back()) {
    result.bca_undefined = "the statistic is the same on every resample";
  } else if (!std::isfinite(result.z0)) {
    result.bca_undefined = "all resamples lie on one side of the estimate";
  } else if (!std::isfinite(result.acceleration)) {
    result.bca_undefined = "the statistic does not change, or is not finite, where values are left out";
  }
  if (!result.bca_undefined.empty()) return;
  const auto corrected = [&](double z) {
    const double shifted = result.z0 + z;
    const double room = 1 - result.acceleration * shifted;
    return room > 0 ? std::erfc(-(result.z0 + shifted / room) / std::sqrt(2.0)) / 2 : not_defined;
  };
  const double z = normal_critical(level);
  const double low = corrected(-z), high = corrected(z);
  if (std::isnan(low) || std::isnan(high)) {
    result.bca_undefined = "the acceleration is too large for the level";
    return;
  }
  result.bca_low = quantile(resampled, low, QuantileType::type_7);
  result.bca_high = quantile(resampled, high, QuantileType::type_7);
}

void check(const Resampling& settings) {
  check_level(settings.level);
  if (settings.resamples < 2) {
    throw std::invalid_argument(fmt::format("{} resamples: expected 2 or more", settings.resamples));
  }
}

// How many standard deviations of the replicates reach as far as Student's t does where the normal distribution has z:
// t for the degrees of freedom, and n by n - 1 because replicates vary as if their mean were known.
double expanded(double z, std::size_t clusters) {
  const auto n = static_cast<double>(clusters);
  return std::sqrt(n / (n - 1)) * t_quantile(1 - normal_two_sided(z) / 2, n - 1);
}

}  // namespace

BootstrapInterval bootstrap(std::span<const double> sample, const Statistic& statistic, const Resampling& settings) {
  check(settings);
  BootstrapInterval result;
  result.undefined = result.bca_undefined = too_few(sample.size());
  if (!result.undefined.empty()) return result;

  result.estimate = statistic(sample);
  result.acceleration = acceleration(sample, statistic);
  Draws draws(settings.seed);
  std::vector<double> resampled, picked(sample.size());
  for (int i = 0; i < settings.resamples; ++i) {
    for (double& value : picked) value = sample[draws.below(sample.size())];
    resampled.push_back(statistic(picked));
  }
  judge(result, std::move(resampled), settings.level);
  return result;
}

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

Interval expanded_percentiles(std::vector<double> replicates, std::size_t clusters, double level) {
  check_level(level);
  const auto is_nan = [](double value) { return std::isnan(value); };
  if (clusters < 2 || replicates.empty() || std::ranges::any_of(replicates, is_nan)) return {};
  const double outside = normal_two_sided(expanded(normal_critical(level), clusters)) / 2;
  const auto last = static_cast<std::ptrdiff_t>(replicates.size()) - 1;
  const auto skipped = static_cast<std::ptrdiff_t>(outside * static_cast<double>(last));
  const auto at = [&](std::ptrdiff_t rank) {
    const auto place = replicates.begin() + rank;
    std::ranges::nth_element(replicates, place);
    return *place;
  };
  return {at(skipped), at(last - skipped)};
}

std::vector<Interval> simultaneous_intervals(const Family& family, double level) {
  check_level(level);
  std::vector<double> spreads, largest;
  for (std::size_t i = 0; i < family.estimates.size(); ++i) {
    const std::vector<double>& replicates = family.replicates[i];
    const double spread = standard_deviation(replicates);
    spreads.push_back(std::isfinite(family.estimates[i] + spread) ? spread : not_defined);
    largest.resize(std::max(largest.size(), replicates.size()));
    if (!(spreads.back() > 0)) continue;
    for (std::size_t b = 0; b < replicates.size(); ++b) {
      largest[b] = std::max(largest[b], std::abs(replicates[b] - family.estimates[i]) / spread);
    }
  }
  std::vector<Interval> intervals(spreads.size());
  if (family.clusters < 2 || largest.empty()) return intervals;
  std::ranges::sort(largest);
  const double critical = expanded(quantile(largest, level, QuantileType::type_7), family.clusters);
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    if (std::isnan(spreads[i])) continue;
    const double half = spreads[i] > 0 ? critical * spreads[i] : 0;
    intervals[i] = {family.estimates[i] - half, family.estimates[i] + half};
  }
  return intervals;
}

}  // namespace ikbench::statistics
