// How many trials have not reached the tolerance yet, at each cost: Kaplan and Meier, JASA 53 (1958) 457, and the mean
// cost up to a horizon (Irwin, Journal of Hygiene 47 (1949) 188). Trials that were given up count for as long as they
// were tried.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/running_time.hpp"

namespace ikbench::statistics {

// The curve falls where trials reach the tolerance. A trial given up at that very cost was still at risk there.
struct SurvivalStep {
  double cost = 0;
  int at_risk = 0;                      // trials that had neither reached it nor been given up before
  int reached = 0;                      // those that reach it here
  double survival = not_defined;        // share that has not reached it, from here to the next step; 1 before the first
  double standard_error = not_defined;  // Greenwood's
};

struct SurvivalCurve {
  std::vector<SurvivalStep> steps;  // ascending; none where no trial reached it
  double last_cost = not_defined;   // of any trial: the curve is known to here, and beyond where it is 0
  double median = not_defined;      // the first cost at which half or more have reached it; NaN where that never is
  std::string undefined;            // why there is no curve; empty where there is
};

SurvivalCurve kaplan_meier(std::span<const CensoredCost> costs);

struct RestrictedMean {
  double mean = not_defined;  // the area under the curve from 0 to the horizon
  double standard_error = not_defined;
  std::string undefined;  // why there is no mean, as of a horizon where the curve is not known; empty where there is
};

RestrictedMean restricted_mean(const SurvivalCurve& curve, double horizon);

// The same of trials in clusters that were drawn (bootstrap.hpp: resampled_clusters), `drawn[c]` times each. Beyond the
// last trial that was drawn the curve stays level (Gill, Large Sample Behaviour of the Product-Limit Estimator (1980)).
class ClusteredSurvival {
 public:
  // Costs that running_time.hpp finds nothing wrong with, and the cluster of each, from 0.
  ClusteredSurvival(std::span<const CensoredCost> costs, std::span<const std::size_t> clusters);

  double restricted_mean(double horizon, std::span<const double> drawn) const;
  // At costs that ascend; a step at a cost counts there.
  std::vector<double> survival_at(std::span<const double> costs, std::span<const double> drawn) const;

 private:
  struct Trial {
    CensoredCost cost;
    std::size_t cluster;
  };
  // Calls `step` with the cost of each step and the survival from there on, in order.
  void walk(std::span<const double> drawn, const std::function<void(double, double)>& step) const;

  std::vector<Trial> trials_;  // ascending in cost
};

}  // namespace ikbench::statistics
