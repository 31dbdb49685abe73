#include "analysis/statistics/proportion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

std::string wrong_with(Successes count) {
  if (count.trials == 0) return "there are no trials";
  if (count.trials > 0 && count.successes >= 0 && count.successes <= count.trials) return {};
  return fmt::format("{} successes in {} trials cannot be", count.successes, count.trials);
}

double share(Successes count) { return static_cast<double>(count.successes) / count.trials; }

}  // namespace

Proportion wilson(Successes count, double level) {
  if (std::string reason = wrong_with(count); !reason.empty()) return {.undefined = reason};
  return wilson_of_mean(share(count), count.trials, level);
}

Proportion wilson_of_mean(double p, int trials, double level) {
  const double z = normal_critical(level);
  Proportion result;
  if (trials < 1) result.undefined = "there are no trials";
  if (!(p >= 0 && p <= 1)) result.undefined = "the mean of the shares is not a share";
  if (!result.undefined.empty()) return result;
  const double n = trials;
  const double centre = p + z * z / (2 * n);
  const double reach = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  const double width = 1 + z * z / n;
  result.estimate = p;
  result.low = p == 0 ? 0.0 : std::max(0.0, (centre - reach) / width);
  result.high = p == 1 ? 1.0 : std::min(1.0, (centre + reach) / width);
  return result;
}

Proportion newcombe(Successes first, Successes second, double level) {
  const Proportion a = wilson(first, level), b = wilson(second, level);
  Proportion result{.undefined = a.undefined.empty() ? b.undefined : a.undefined};
  if (!result.undefined.empty()) return result;
  result.estimate = a.estimate - b.estimate;
  result.low = result.estimate - std::hypot(a.estimate - a.low, b.high - b.estimate);
  result.high = result.estimate + std::hypot(a.high - a.estimate, b.estimate - b.low);
  return result;
}

FisherExact fisher_exact(Successes first, Successes second) {
  FisherExact test{.undefined = wrong_with(first)};
  if (test.undefined.empty()) test.undefined = wrong_with(second);
  if (!test.undefined.empty()) return test;
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
  double total = 0, seen_weight = 0, as_rare = 0, as_many = 0;
  for_each_weight([&](double x, double weight) {
    total += weight;
    if (x == seen) seen_weight = weight;
    if (x >= seen) as_many += weight;
  });
  for_each_weight([&](double, double weight) {
    if (weight <= seen_weight * (1 + 1e-7)) as_rare += weight;  // equal up to rounding, as in R
  });
  test.p = std::min(1.0, as_rare / total);
  test.p_greater = std::min(1.0, as_many / total);
  return test;
}

double most_without_success(int trials, double significance) {
  return trials < 1 ? 1 : 1 - std::pow(significance, 1.0 / trials);
}

double trials_to_exclude(double share, double significance) {
  if (!(share > 0 && share < 1)) return not_defined;
  return std::ceil(std::log(significance) / std::log1p(-share));
}

}  // namespace ikbench::statistics
