// Shares of trials that succeeded: the interval of one, the difference of two, and Fisher's exact test of them.
#pragma once

#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// So many of so many; neither negative nor more successes than trials, and at least one trial, or nothing is defined.
struct Successes {
  int successes = 0;
  int trials = 0;
};

struct Proportion {  // or a difference of two
  double estimate = not_defined;
  double low = not_defined;
  double high = not_defined;
  std::string undefined;  // why there is no estimate; empty where there is
};

// Wilson's score interval (JASA 22 (1927) 209): near the level on average.
Proportion wilson(Successes count, double level = 0.95);
// The same where each trial is a share itself, as of several attempts that are not independent, and `mean` is the mean
// of those shares. Shares vary no more than successes and failures of the same mean do, so the interval is no narrower
// than it must be.
Proportion wilson_of_mean(double mean, int trials, double level = 0.95);

// The share of the first less that of the second. The interval is Newcombe's hybrid of Wilson's two (Statistics in
// Medicine 17 (1998) 873, method 10): as far from the difference as Wilson's limits are from the shares.
Proportion newcombe(Successes first, Successes second, double level);

// Have two the same chance? Conditional on the totals; two-sided: all tables no more probable than the one seen.
struct FisherExact {
  double p = not_defined;
  double p_greater = not_defined;  // one-sided: the first has the greater chance
  std::string undefined;           // why there is no p; empty where there is
};

FisherExact fisher_exact(Successes first, Successes second);

// The largest chance that so many trials without a success do not exclude, one-sided: 1 - significance^(1 / trials).
double most_without_success(int trials, double significance);
// From how many trials on that chance is at most `share`; NaN where no number is enough.
double trials_to_exclude(double share, double significance);

}  // namespace ikbench::statistics
