// Compares successes of groups that were all given the same trials: two of them pair by pair, or all.
#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/proportion.hpp"

namespace ikbench::statistics {

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

// Tests whether all have the same chance: Cochran, Biometrika 37 (1950) 256; Q with p of chi-square, poor if few trials
// distinguish groups.
// Needs two groups or more of values 0 and 1; values[i] of each is of trial i.
Test cochran_q(std::span<const std::vector<double>> groups);

}  // namespace ikbench::statistics
