#include "analysis/statistics/bootstrap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench {
namespace {

// A resample is which values of each sample are taken; what is done with them is the statistic's business.
using Picks = std::vector<std::vector<std::size_t>>;
using PickStatistic = std::function<double(const Picks&)>;

constexpr std::size_t most_left_out = 1000;  // values of a sample that the acceleration leaves out in turn
constexpr std::size_t most_exhaustive = 7;   // 7^7 = 823543

std::vector<double> picked(std::span<const double> values, const std::vector<std::size_t>& picks) {
  std::vector<double> result;
  result.reserve(picks.size());
  for (const std::size_t pick : picks) result.push_back(values[pick]);
  return result;
}

Picks everything(std::span<const std::size_t> sizes) {
  Picks picks;
  for (const std::size_t size : sizes) {
    for (std::size_t i = picks.emplace_back().size(); i < size; ++i) picks.back().push_back(i);
  }
  return picks;
}

std::string too_few(std::span<const std::size_t> sizes) {
  for (const std::size_t size : sizes) {
    if (size < 2) return size == 0 ? "a sample has no values" : "a sample of one value cannot be resampled";
  }
  return {};
}

// 0 to bound - 1, each equally likely: draws from the incomplete last round of the engine's range are drawn again.
std::size_t draw(std::mt19937_64& engine, std::uint64_t bound) {
  constexpr std::uint64_t range = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t limit = range - range % bound;
  std::uint64_t number = engine();
  while (number >= limit) number = engine();
  return static_cast<std::size_t>(number % bound);
}

// Efron's acceleration from the statistic without each value in turn, of several samples as Davison and Hinkley (5.27).
// Of a large sample a thousand values, evenly spaced, stand for all, so that the work does not grow with the square.
double acceleration(std::span<const std::size_t> sizes, const PickStatistic& statistic) {
  Picks picks = everything(sizes);
  double squares = 0, cubes = 0;
  for (std::size_t s = 0; s < sizes.size(); ++s) {
    const std::size_t left_out = std::min(sizes[s], most_left_out);
    const std::vector<std::size_t> all = picks[s];
    std::vector<double> without;
    for (std::size_t i = 0; i < left_out; ++i) {
      picks[s] = all;
      picks[s].erase(picks[s].begin() + static_cast<std::ptrdiff_t>((2 * i + 1) * sizes[s] / (2 * left_out)));
      without.push_back(statistic(picks));
    }
    picks[s] = all;
    const double centre = mean(without);
    const auto n = static_cast<double>(sizes[s]);
    const double stands_for = n / static_cast<double>(left_out);
    for (const double value : without) {
      const double influence = (n - 1) / n * (centre - value);
      squares += stands_for * influence * influence;
      cubes += stands_for * influence * influence * influence;
    }
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
  const double variance = sum_of_squares(resampled) / static_cast<double>(resampled.size() - 1);
  if (result.undefined.empty() && !std::isfinite(variance)) {
    result.undefined = "the spread is too large for double precision";
  }
  result.bca_undefined = result.undefined;
  if (!result.undefined.empty()) return;

  std::ranges::sort(resampled);
  const double outside = (1 - level) / 2;
  result.standard_error = std::sqrt(std::max(0.0, variance));
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

BootstrapInterval resample(std::span<const std::size_t> sizes, const PickStatistic& statistic,
                           const Resampling& settings) {
  check_level(settings.level);
  if (settings.resamples < 2) {
    throw std::invalid_argument(fmt::format("{} resamples: expected 2 or more", settings.resamples));
  }
  BootstrapInterval result;
  result.undefined = result.bca_undefined = too_few(sizes);
  if (!result.undefined.empty()) return result;

  Picks picks = everything(sizes);
  result.estimate = statistic(picks);
  result.acceleration = acceleration(sizes, statistic);
  std::mt19937_64 engine(settings.seed);
  std::vector<double> resampled;
  for (int i = 0; i < settings.resamples; ++i) {
    for (std::vector<std::size_t>& sample : picks) {
      for (std::size_t& pick : sample) pick = draw(engine, sample.size());
    }
    resampled.push_back(statistic(picks));
  }
  judge(result, std::move(resampled), settings.level);
  return result;
}

}  // namespace

BootstrapInterval bootstrap(std::span<const double> sample, const Statistic& statistic, const Resampling& settings) {
  const std::size_t sizes[] = {sample.size()};
  return resample(
      sizes, [&](const Picks& picks) { return statistic(picked(sample, picks[0])); }, settings);
}

BootstrapInterval bootstrap_two(std::span<const double> first, std::span<const double> second,
                                const TwoSampleStatistic& statistic, const Resampling& settings) {
  const std::size_t sizes[] = {first.size(), second.size()};
  return resample(
      sizes, [&](const Picks& picks) { return statistic(picked(first, picks[0]), picked(second, picks[1])); },
      settings);
}

BootstrapInterval bootstrap_pairs(std::span<const double> first, std::span<const double> second,
                                  const TwoSampleStatistic& statistic, const Resampling& settings) {
  if (first.size() != second.size()) {
    const std::string reason = fmt::format("{} and {} values are not pairs", first.size(), second.size());
    return {.undefined = reason, .bca_undefined = reason};
  }
  const std::size_t sizes[] = {first.size()};
  return resample(
      sizes, [&](const Picks& picks) { return statistic(picked(first, picks[0]), picked(second, picks[0])); },
      settings);
}

BootstrapInterval bootstrap_exhaustive(std::span<const double> sample, const Statistic& statistic, double level) {
  check_level(level);
  const std::size_t sizes[] = {sample.size()};
  const PickStatistic of_picks = [&](const Picks& picks) { return statistic(picked(sample, picks[0])); };
  BootstrapInterval result;
  result.undefined = too_few(sizes);
  if (sample.size() > most_exhaustive) {
    result.undefined = fmt::format("{} values have too many resamples to go through", sample.size());
  }
  result.bca_undefined = result.undefined;
  if (!result.undefined.empty()) return result;

  result.estimate = of_picks(everything(sizes));
  result.acceleration = acceleration(sizes, of_picks);
  std::vector<double> resampled;
  Picks picks{std::vector<std::size_t>(sample.size(), 0)};
  std::vector<std::size_t>& digits = picks[0];  // counts through all of them
  for (auto digit = digits.begin(); digit != digits.end();) {
    resampled.push_back(of_picks(picks));
    for (digit = digits.begin(); digit != digits.end() && ++*digit == sample.size(); ++digit) *digit = 0;
  }
  judge(result, std::move(resampled), level);
  return result;
}

}  // namespace ikbench
