#include "analysis/statistics/predictive_study.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::statistics {
namespace {

// Draws from (0, 1).
double open_uniform(Draws& draws) { return (static_cast<double>(draws.below(1u << 31)) + 0.5) * 0x1p-31; }

// Mean excess of the outermost fifth over the next: the slope of an exponential tail.
double tail_slope(std::span<const double> outwards) {
  const std::size_t tail = std::max<std::size_t>(2, outwards.size() / 5);
  double sum = 0;
  for (std::size_t i = outwards.size() - tail; i < outwards.size(); ++i) {
    sum += std::abs(outwards[i] - outwards[outwards.size() - tail - 1]);
  }
  return sum / static_cast<double>(tail);
}

// Draws the values of a future study from the sorted logarithms of those that are known.
std::vector<double> next_study(std::vector<double> known, std::size_t runs, double slope_below, double slope_above,
                               Draws& draws) {
  std::vector<double> study;
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t gap = draws.below(known.size() + 1);
    const double u = open_uniform(draws);
    const double value = gap == 0              ? known.front() + slope_below * std::log(u)
                         : gap == known.size() ? known.back() - slope_above * std::log(u)
                                               : known[gap - 1] + u * (known[gap] - known[gap - 1]);
    known.insert(known.begin() + static_cast<std::ptrdiff_t>(gap), value);
    study.push_back(std::exp(value));
  }
  return study;
}

}  // namespace

PredictedRanges predicted_ranges(std::span<const double> values, std::size_t runs, const Resampling& settings) {
  PredictedRanges ranges{};
  if (values.size() < fewest_predicting || runs < 1) return ranges;
  std::vector<double> logs;
  for (const double value : values) {
    if (!(value > 0) || !std::isfinite(value)) return ranges;
    logs.push_back(std::log(value));
  }
  std::ranges::sort(logs);
  const double above = tail_slope(logs), below = tail_slope(std::vector<double>(logs.rbegin(), logs.rend()));
  Draws draws(settings.seed);
  std::array<std::vector<double>, predicted_statistics> replicates;
  for (int i = 0; i < settings.resamples; ++i) {
    const Description study = describe(next_study(logs, runs, below, above, draws));
    const std::array numbers{study.mean, study.median, study.std, study.max, study.min};
    for (std::size_t s = 0; s < numbers.size(); ++s) replicates[s].push_back(numbers[s]);
  }
  const double tail = (1 - settings.level) / 2;
  for (std::size_t s = 0; s < predicted_statistics; ++s) {
    const std::vector<double> sorted = ranked_values(replicates[s]);
    ranges[s] = {.low = quantile(sorted, tail, QuantileType::type_7),
                 .high = quantile(sorted, 1 - tail, QuantileType::type_7)};
  }
  return ranges;
}

}  // namespace ikbench::statistics
