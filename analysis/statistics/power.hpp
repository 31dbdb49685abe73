// The number of runs that a comparison needs: Welch's t-test, with Satterthwaite's degrees of freedom, and the paired
// one, through the noncentral t distribution (Cohen 1988).
#pragma once

#include <functional>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

constexpr double most_runs = 1e7;  // larger numbers are not searched for

// The smallest whole number above 1 that is enough, if all larger ones are, too; infinity beyond `most_runs`. The
// search begins at the guess, a whole number above 1.
double smallest_number(double guess, const std::function<bool(double)>& is_enough);

struct PowerGoal {
  double power = 0.8;   // the chance to find an existing difference
  double alpha = 0.05;  // the chance to find one that does not exist; two-sided
};

// The smallest equal n per group with which Welch's test shows a true difference of means if the groups spread as
// these: a whole number of at least 2; infinity beyond `most_runs`; NaN without a difference or a spread. Throws
// std::invalid_argument unless 0 < alpha < power < 1.
double runs_to_see(const GroupSummary& a, const GroupSummary& b, double difference, const PowerGoal& goal);
// The smallest number of pairs with which the paired test shows it if differences within pairs spread by `std`.
double pairs_to_see(double std, double difference, const PowerGoal& goal);

// The least difference of two means of n values each, in their standard deviations, that Student's test shows with that
// power; of pairs the least mean of n differences, in their standard deviation. NaN for fewer than two.
double least_difference(int n, bool is_paired, const PowerGoal& goal);

// The standard deviation that is below the true one with that probability, if n normal values have `std`.
double plausible_deviation(double std, int n, double probability);

}  // namespace ikbench::statistics
