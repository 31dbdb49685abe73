#include "analysis/statistics/proportion.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

bool is_possible(Successes count) {
  return count.trials > 0 && count.successes >= 0 && count.successes <= count.trials;
}

}  // namespace

Estimate wilson(Successes count, double level) {
  const double share = static_cast<double>(count.successes) / count.trials;
  return wilson_of_mean(is_possible(count) ? share : not_defined, count.trials, level);
}

Estimate wilson_of_mean(double p, int trials, double level) {
  const double z = normal_critical(level);
  if (trials < 1 || !(p >= 0 && p <= 1)) return {};
  const double n = trials;
  const double centre = p + z * z / (2 * n);
  const double reach = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  const double width = 1 + z * z / n;
  return {.value = p,
          .low = p == 0 ? 0.0 : std::max(0.0, (centre - reach) / width),
          .high = p == 1 ? 1.0 : std::min(1.0, (centre + reach) / width)};
}

Estimate newcombe(Successes first, Successes second, double level) {
  const Estimate a = wilson(first, level), b = wilson(second, level);
  const double difference = a.value - b.value;
  return {.value = difference,
          .low = difference - std::hypot(a.value - a.low, b.high - b.value),
          .high = difference + std::hypot(a.high - a.value, b.value - b.low)};
}

double fisher_exact(Successes first, Successes second) {
  if (!is_possible(first) || !is_possible(second)) return not_defined;
  const double n1 = first.trials, n2 = second.trials;
  const double seen = first.successes;
  const double successes = seen + second.successes;

  // Weights of the first's successes, given all: relative to the most probable number, going out from it until they
  // vanish, each from its neighbour.
  const double least = std::max(0.0, successes - n2), most = std::min(n1, successes);
  const double mode = std::clamp(std::floor((n1 + 1) * (successes + 1) / (n1 + n2 + 2)), least, most);
  const auto odds_of_next = [&](double x) { return (n1 - x) * (successes - x) / ((x + 1) * (n2 - successes + x + 1)); };
  constexpr double vanished = std::numeric_limits<double>::min();  // below it a weight may not shrink any more
  const auto for_each_weight = [&](const auto& use) {
    double weight = 1;
    for (double x = mode; x <= most && weight >= vanished; weight *= odds_of_next(x++)) use(x, weight);
    weight = 1;
    for (double x = mode; x > least;) {
      weight /= odds_of_next(--x);
      if (weight < vanished) break;
      use(x, weight);
    }
  };
  double total = 0, seen_weight = 0, as_rare = 0;
  for_each_weight([&](double x, double weight) {
    total += weight;
    if (x == seen) seen_weight = weight;
  });
  for_each_weight([&](double, double weight) {
    if (weight <= seen_weight * (1 + 1e-7)) as_rare += weight;  // equal up to rounding, as in R
  });
  return std::min(1.0, as_rare / total);
}

double most_without_success(int trials, double significance) {
  return trials < 1 ? 1 : 1 - std::pow(significance, 1.0 / trials);
}

double mcnemar_exact(const PairedSuccesses& counts) {
  const int apart = counts.first_only + counts.second_only;
  if (apart == 0) return 1;
  const boost::math::binomial even(apart, 0.5);
  return std::min(1.0, 2 * boost::math::cdf(even, std::min(counts.first_only, counts.second_only)));
}

Estimate newcombe_paired(const PairedSuccesses& counts, double level) {
  const int n = counts.trials();
  const Estimate first = wilson({.successes = counts.both + counts.first_only, .trials = n}, level);
  const Estimate second = wilson({.successes = counts.both + counts.second_only, .trials = n}, level);
  const double a = counts.both, b = counts.first_only, c = counts.second_only, d = counts.neither;
  const double margins = (a + b) * (c + d) * (a + c) * (b + d);
  const double excess = a * d - b * c;
  const double phi = margins == 0 ? 0 : (excess > 0 ? std::max(0.0, excess - n / 2.0) : excess) / std::sqrt(margins);
  const auto reach = [&](double one, double other) {
    return std::sqrt(std::max(0.0, one * one - 2 * phi * one * other + other * other));
  };
  const double difference = (b - c) / n;
  return {.value = difference,
          .low = difference - reach(first.value - first.low, second.high - second.value),
          .high = difference + reach(first.high - first.value, second.value - second.low)};
}

}  // namespace ikbench::statistics
