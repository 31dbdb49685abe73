// How many runs a comparison needs, and what a number of runs can show: Student's and Welch's t-test through the
// noncentral t distribution (Cohen 1988; Welch's with Satterthwaite's degrees of freedom), Mann-Whitney's by Noether
// (1987).
#pragma once

#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct PowerGoal {
  double power = 0.8;   // the chance to find a difference that is there
  double alpha = 0.05;  // the chance to find one that is not; two-sided
};

struct RunsNeeded {
  double n = not_defined;  // per group, a whole number of at least 2
  std::string undefined;   // why there is none, one above ten million too; empty where there is
};

// Power of the two-sided two-sample t-test at a standardized difference d of n per group (not necessarily whole); NaN
// where n < 2 or alpha is not between 0 and 1.
double t_test_power(double d, double n, double alpha);

// The smallest n per group with that power. Here and below std::invalid_argument unless 0 < alpha < power < 1.
RunsNeeded runs_needed(double d, const PowerGoal& goal);

// The smallest |d| that n per group show with that power; NaN where n < 2 or there is none below a million.
double smallest_effect(double n, const PowerGoal& goal);

// The smallest equal n per group with which Welch's test shows a true difference of means where the groups spread as
// these.
RunsNeeded runs_to_see(const GroupSummary& a, const GroupSummary& b, double difference, const PowerGoal& goal);

// The n per group with which the Mann-Whitney test shows P(a > b) + P(a = b) / 2 = a12: (z_(alpha/2) + z_power)^2 /
// (6 (a12 - 1/2)^2), for large samples (Noether, J. American Statistical Association 82 (1987) 645).
RunsNeeded runs_for_rank_test(double a12, const PowerGoal& goal);

}  // namespace ikbench::statistics
