// Shares of trials that succeeded: the interval of one, the difference of two, and Fisher's exact test of them.
#pragma once

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// Successes among trials. What is made of them is defined for at least one trial,
// and for 0 to `trials` successes.
struct Successes {
  int successes = 0;
  int trials = 0;
};

// Wilson's score interval (JASA 22 (1927) 209): near the level on average.
Estimate wilson(Successes count, double level = 0.95);
// The same if each trial is itself a share, such as of several dependent attempts, and `mean` is the mean of those
// shares. Shares vary no more than successes and failures of the same mean, so the interval is not too narrow.
Estimate wilson_of_mean(double mean, int trials, double level = 0.95);

// The share of the first less that of the second. The interval is Newcombe's hybrid of Wilson's two (Statistics in
// Medicine 17 (1998) 873, method 10): as far from the difference as Wilson's limits are from the shares.
Estimate newcombe(Successes first, Successes second, double level);

// The p of Fisher's test whether two have the same chance. Conditional on the totals; two-sided: all tables no more
// probable than the observed one.
double fisher_exact(Successes first, Successes second);

// The largest chance that so many trials without a success do not exclude, one-sided: 1 - significance^(1 / trials).
double most_without_success(int trials, double significance);

// Compares successes of groups that were all given the same trials: pair by pair.

// The numbers of trials in which both succeeded, one alone, or neither.
struct PairedSuccesses {
  int both = 0;
  int first_only = 0;
  int second_only = 0;
  int neither = 0;

  int trials() const { return both + first_only + second_only + neither; }
};

// Tests whether two have the same chance: the two-sided sign test of the trials in which one alone succeeded (McNemar,
// Psychometrika 12 (1947) 153, exact); 1 if there are none.
double mcnemar_exact(const PairedSuccesses& counts);

// The share of the first less that of the second, with Newcombe's interval for pairs (Statistics in Medicine 17 (1998)
// 2635, method 10): his interval for independent samples, with the correlation of the two.
Estimate newcombe_paired(const PairedSuccesses& counts, double level);

}  // namespace ikbench::statistics
