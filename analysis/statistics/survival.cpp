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

ClusteredSurvival::ClusteredSurvival(std::span<const CensoredCost> costs, std::span<const std::size_t> clusters) {
  for (std::size_t i = 0; i < costs.size(); ++i) trials_.push_back({costs[i], clusters[i]});
  std::ranges::sort(trials_, {}, [](const Trial& trial) { return trial.cost.spent; });
}

void ClusteredSurvival::walk(std::span<const double> drawn, const std::function<void(double, double)>& step) const {
  double at_risk = 0, survival = 1;
  for (const Trial& trial : trials_) at_risk += drawn[trial.cluster];
  for (std::size_t first = 0, end = 0; first < trials_.size(); first = end) {
    const double cost = trials_[first].cost.spent;
    double reached = 0, left = 0;
    for (; end < trials_.size() && trials_[end].cost.spent == cost; ++end) {
      (trials_[end].cost.reached ? reached : left) += drawn[trials_[end].cluster];
    }
    if (reached > 0) {
      survival *= (at_risk - reached) / at_risk;
      step(cost, survival);
    }
    at_risk -= reached + left;
  }
}

double ClusteredSurvival::restricted_mean(double horizon, std::span<const double> drawn) const {
  double area = 0, at = 0, height = 1;
  walk(drawn, [&](double cost, double survival) {
    const double right = std::min(cost, horizon);
    area += (right - at) * height;
    at = right;
    height = survival;
  });
  return area + (horizon - at) * height;
}

std::vector<double> ClusteredSurvival::survival_at(std::span<const double> costs, std::span<const double> drawn) const {
  std::vector<double> result;
  double height = 1;
  walk(drawn, [&](double cost, double survival) {
    while (result.size() < costs.size() && costs[result.size()] < cost) result.push_back(height);
    height = survival;
  });
  result.resize(costs.size(), height);
  return result;
}

}  // namespace ikbench::statistics
