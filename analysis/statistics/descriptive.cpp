#include "analysis/statistics/descriptive.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/quantile.hpp"

namespace ikbench {

double mean(std::span<const double> values) {
  if (values.empty()) return not_defined;
  const double shift = values.front();
  double sum = 0;
  for (const double value : values) sum += value - shift;
  return shift + sum / static_cast<double>(values.size());
}

double sum_of_squares(std::span<const double> values) {
  if (values.empty()) return not_defined;
  const double shift = values.front();
  const double n = static_cast<double>(values.size());
  double shifted_mean = 0;
  for (const double value : values) shifted_mean += (value - shift) / n;
  double squares = 0;
  double rest = 0;  // what rounding left in the mean (Chan, Golub, LeVeque 1983)
  for (const double value : values) {
    const double deviation = (value - shift) - shifted_mean;
    squares += deviation * deviation;
    rest += deviation;
  }
  return squares - rest * rest / n;
}

Description describe(std::span<const double> values) {
  Description result;
  result.n = static_cast<int>(values.size());
  const std::vector<double> ranked = ranked_values(values);
  result.not_finite = static_cast<int>(std::ranges::count(ranked, worse_than_every_number));
  if (ranked.empty()) return result;
  result.median = quantile(ranked, 0.5, QuantileType::type_5);
  result.min = ranked.front();
  result.max = ranked.back();
  if (result.not_finite > 0) return result;
  result.mean = mean(values);
  if (result.n > 1) result.std = std::sqrt(sum_of_squares(values) / (result.n - 1));
  return result;
}

GroupSummary summarise(std::span<const double> values) {
  const Description described = describe(values);
  return {.mean = described.mean, .std = described.std, .n = described.n};
}

}  // namespace ikbench
