// How many trials have not reached the tolerance yet, at each cost: Kaplan and Meier, JASA 53 (1958) 457, and the mean
// cost up to a horizon (Irwin, Journal of Hygiene 47 (1949) 188). Trials that were given up count for as long as they
// were tried.
#pragma once

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

}  // namespace ikbench::statistics
