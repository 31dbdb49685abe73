#include "analysis/statistics/survival.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ikbench::statistics {
namespace {

// Greenwood's term of a step, the relative variance that it adds. Where all that were at risk reach it nothing is left.
double greenwood(const SurvivalStep& step) {
  const double left = step.at_risk - step.reached;
  return left > 0 ? step.reached / (step.at_risk * left) : 0.0;
}

}  // namespace

SurvivalCurve kaplan_meier(std::span<const CensoredCost> costs) {
  SurvivalCurve curve{.undefined = wrong_with(costs)};
  if (!curve.undefined.empty()) return curve;
  std::vector<CensoredCost> sorted(costs.begin(), costs.end());
  std::ranges::sort(sorted, {}, &CensoredCost::spent);
  curve.last_cost = sorted.back().spent;
  constexpr double half = 0.5 + 1e-12;  // a product of fractions is rarely exact
  double survival = 1, relative_variance = 0;
  for (std::size_t first = 0, end = 0; first < sorted.size(); first = end) {
    SurvivalStep step{.cost = sorted[first].spent, .at_risk = static_cast<int>(sorted.size() - first)};
    for (; end < sorted.size() && sorted[end].spent == step.cost; ++end) step.reached += sorted[end].reached ? 1 : 0;
    if (step.reached == 0) continue;
    survival *= static_cast<double>(step.at_risk - step.reached) / step.at_risk;
    relative_variance += greenwood(step);
    step.survival = survival;
    step.standard_error = survival * std::sqrt(relative_variance);
    curve.steps.push_back(step);
    if (std::isnan(curve.median) && survival <= half) curve.median = step.cost;
  }
  return curve;
}

RestrictedMean restricted_mean(const SurvivalCurve& curve, double horizon) {
  RestrictedMean result{.undefined = curve.undefined};
  if (!result.undefined.empty()) return result;
  const bool ends_at_zero = !curve.steps.empty() && curve.steps.back().survival == 0;
  if (!std::isfinite(horizon) || horizon < 0) {
    result.undefined = fmt::format("a horizon of {}", horizon);
  } else if (horizon > curve.last_cost && !ends_at_zero) {
    result.undefined = fmt::format("nothing is known beyond {}, where the last trial was given up", curve.last_cost);
  }
  if (!result.undefined.empty()) return result;

  // From the horizon back: the area beyond each step, which the variance weighs the step's term with.
  double area = 0, variance = 0, right = horizon;
  for (auto step = curve.steps.rbegin(); step != curve.steps.rend(); ++step) {
    if (step->cost >= horizon) continue;
    area += (right - step->cost) * step->survival;
    variance += area * area * greenwood(*step);
    right = step->cost;
  }
  result.mean = area + right;
  result.standard_error = std::sqrt(variance);
  return result;
}

}  // namespace ikbench::statistics
