// The bias-corrected, accelerated bootstrap interval of a mean (Efron, JASA 82 (1987) 171; Davison and Hinkley,
// Bootstrap Methods and their Application (1997), section 5.3.2), which the studentized interval is compared with.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/draw.hpp"
#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

// Needs two different finite values or more; NaN if all resamples lie on one side of the mean.
inline Estimate bca_of_mean(std::span<const double> sample, const Resampling& settings = {}) {
  Draws draws(settings.seed);
  std::vector<double> means, picked(sample.size());
  for (int i = 0; i < settings.resamples; ++i) {
    for (double& value : picked) value = sample[draws.below(sample.size())];
    means.push_back(mean(picked));
  }
  std::ranges::sort(means);
  const double centre = mean(sample);
  double squares = 0, cubes = 0;
  for (const double value : sample) {
    squares += std::pow(value - centre, 2);
    cubes += std::pow(value - centre, 3);
  }
  const double acceleration = cubes / (6 * std::pow(squares, 1.5));
  const auto below = std::ranges::lower_bound(means, centre) - means.begin();
  const double z0 = normal_quantile(static_cast<double>(below) / static_cast<double>(means.size()));
  const auto end = [&](double z) {
    const double corrected = z0 + (z0 + z) / (1 - acceleration * (z0 + z));
    if (!std::isfinite(corrected)) return not_defined;
    return quantile(means, std::erfc(-corrected / std::sqrt(2.0)) / 2, QuantileType::type_7);
  };
  const double z = normal_critical(settings.level);
  return {.value = centre, .low = end(-z), .high = end(z)};
}

}  // namespace ikbench::statistics
