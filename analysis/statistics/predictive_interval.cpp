#include "analysis/statistics/predictive_interval.hpp"

#include <vector>

#include "analysis/statistics/quantile.hpp"

namespace ikbench::statistics {

Interval predictive_interval(std::span<const double> values, double level) {
  const std::vector<double> sorted = ranked_values(values);
  const auto at = [&](double p) { return quantile(sorted, p, QuantileType::type_6); };
  return {.low = at((1 - level) / 2), .high = at((1 + level) / 2)};
}

}  // namespace ikbench::statistics
