#include "analysis/statistics/predictive_study.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/draw.hpp"
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

class NextValues {
 public:
  NextValues(std::vector<double> sorted_logs, std::size_t runs) : known_(std::move(sorted_logs)), runs_(runs) {
    above_ = tail_slope(known_);
    below_ = tail_slope(std::vector<double>(known_.rbegin(), known_.rend()));
  }

  // Draws the values of one future study.
  std::vector<double> draw_study(Draws& draws) const {
    std::vector<double> known = known_, study;
    for (std::size_t run = 0; run < runs_; ++run) {
      const std::size_t gap = draws.below(known.size() + 1);
      const double u = open_uniform(draws);
      const double value = gap == 0              ? known.front() + below_ * std::log(u)
                           : gap == known.size() ? known.back() - above_ * std::log(u)
                                                 : known[gap - 1] + u * (known[gap] - known[gap - 1]);
      known.insert(known.begin() + static_cast<std::ptrdiff_t>(gap), value);
      study.push_back(std::exp(value));
    }
    return study;
  }

 private:
  std::vector<double> known_;
  std::size_t runs_;
  double above_ = 0, below_ = 0;
};

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
  const NextValues next(std::move(logs), runs);
  Draws draws(settings.seed);
  std::array<std::vector<double>, predicted_statistics> replicates;
  for (int i = 0; i < settings.resamples; ++i) {
    const Description study = describe(next.draw_study(draws));
    replicates[0].push_back(study.mean);
    replicates[1].push_back(study.median);
    replicates[2].push_back(study.std);
    replicates[3].push_back(study.max);
    replicates[4].push_back(study.min);
  }
  const double tail = (1 - settings.level) / 2;
  for (std::size_t s = 0; s < predicted_statistics; ++s) {
    const std::vector<double> sorted = ranked_values(replicates[s]);
    ranges[s] = {.low = quantile(sorted, tail, QuantileType::type_7),
                 .high = quantile(sorted, 1 - tail, QuantileType::type_7)};
  }
  return ranges;
}

Estimate predictive_interval(std::span<const double> values, double level) {
  const std::vector<double> sorted = ranked_values(values);
  const auto at = [&](double p) { return quantile(sorted, p, QuantileType::type_6); };
  return {.low = at((1 - level) / 2), .high = at((1 + level) / 2)};
}

}  // namespace ikbench::statistics
