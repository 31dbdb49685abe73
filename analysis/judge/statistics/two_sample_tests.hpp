// Tests of two samples. Every p is two-sided and unadjusted, and an interval has the confidence 1 - alpha. The tests
// know no floors, margins or copies: `pair_data.hpp` makes their numbers, and `compare_pairs.hpp` chooses the test and
// corrects p. docs/explanation/methods.md explains the choice.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/judge/data/samples.hpp"

namespace ikbench::judge {

using Values = std::span<const double>;

// A confidence interval, or a range.
struct Interval {
  double low = 0, high = 0;
  bool excludes_low = false, excludes_high = false;  // "above 0", "below 1"
};

// The result of one test of first - second, before any correction.
struct UnadjustedTest {
  double estimate = 0;
  double p = 1;
  int direction = 0;                      // 1: the first is larger, -1: the second
  std::optional<Interval> interval = {};  // empty: too few values, or values without spread
};

// Returns the critical value of the normal distribution for a two-sided test at `alpha`.
double critical_z(double alpha);

// Returns n, mean and standard deviation in two passes, shifted by the first value. A deviation that is only rounding
// is 0. `values` must not be empty.
SummaryStatistics summarise(Values values);

// A value with its place in the list. Such pairs stay in the cache when sorted, which places by themselves would not.
using IndexedValue = std::pair<double, std::size_t>;
// Returns the values in ascending order, each with its place.
std::vector<IndexedValue> sorted_with_index(Values values);

// Return the smallest p that a rank test or an exact test of proportions can give for samples of these sizes.
double min_p_unpaired(std::size_t m, std::size_t n);  // 2 / C(m + n, m)
double min_p_paired(std::size_t n);                   // 2^(1 - n)

// Returns the interval of a quantile by order statistics, whatever the distribution. `sorted` must be ascending. Empty
// if there are too few values: for the 95 % quantile at 95 % confidence fewer than 72.
std::optional<Interval> quantile_interval(Values sorted, double share, double alpha = 0.05);

// Numbers, unpaired.

// Returns p of Brunner and Munzel's test of `first` less a shift, by Student's t (Biometrical J. 42 (2000) 17). Both
// samples must be ascending. Without variance p is 0 if the samples do not overlap, and 1 if they are equal.
double brunner_munzel(Values first, Values second, double shift = 0);
// Returns p of Mann and Whitney's test: exact, also with ties, for m + n <= 100; above normal, with corrections for
// ties and continuity (Annals of Mathematical Statistics 18 (1947) 50).
double mann_whitney(Values first, Values second);
// Returns the larger p of these two tests with Hodges and Lehmann's shift (Annals of Mathematical Statistics 34 (1963)
// 598). The interval has the shifts that either test keeps; Mann-Whitney's part of it assumes no ties.
UnadjustedTest rank_test(Values first, Values second, double alpha);
// No limit of the effective sample size.
constexpr double unlimited = std::numeric_limits<double>::infinity();
// Returns Welch's t test (Biometrika 34 (1947) 28). Two constant samples have the p of the permutations,
// 2 / C(m + n, m). `worth` is the effective sample size of values that are made of a sum: the degrees of freedom of
// each sample are at most `worth` - 1, but at least 1.
UnadjustedTest welch(const SummaryStatistics& first, const SummaryStatistics& second, double alpha,
                     double worth = unlimited);

// Returns the interval of A12, the chance that a value of `first` is larger than one of `second`, with equal ones half:
// from the lower to the higher end of Newcombe's (Statistics in Medicine 25 (2006) 559, method 5) and of the normal
// interval of the logit with the variance of Brunner and Munzel (Biometrical J. 42 (2000) 17) and their Student's t.
Interval a12_interval(Values first, Values second, double alpha);

// Numbers, paired: by the differences first - second, which must not be empty.

// Returns Wilcoxon's signed rank test (Biometrics 1 (1945) 80), exact to n = 1000. Differences of 0 have no rank. The
// estimate is the median of all means of two differences.
UnadjustedTest signed_rank_test(Values differences, double alpha);
// Returns Student's t test (Biometrika 6 (1908) 1). Equal differences have the p of the permutations, 2^(1 - n).
// `worth` is the effective sample size, as in `welch`.
UnadjustedTest t_test(Values differences, double alpha, double worth = unlimited);
// Returns the test of the signs of all differences that are not 0 (Dixon and Mood, JASA 41 (1946) 557). The estimate is
// the median, with the interval of its order statistics.
UnadjustedTest sign_test(Values differences, double alpha);

// Proportions.

// The share of successes among `n` trials.
struct Proportion {
  double share = 0;  // from 0 to 1
  double n = 0;
};

// Returns Wilson's interval of a share (JASA 22 (1927) 209), which may be a mean of shares.
Interval wilson_interval(const Proportion& proportion, double alpha);
// Returns the interval of Clopper and Pearson of a share (Biometrika 26 (1934) 404), in which a tie counts as half a
// success.
Interval clopper_pearson_interval(const Proportion& proportion, double alpha);
// Returns Newcombe's interval of first - second (Statistics in Medicine 17 (1998) 873, method 10; for correlated shares
// 2635, method 10).
Interval newcombe_interval(const Proportion& first, const Proportion& second, double alpha, double correlation = 0);
// Returns Fisher's exact test of values 0 and 1: p counts all tables that are no more probable than this one (Fisher,
// Statistical Methods for Research Workers, 5th ed. 1934, section 21.02). The interval is Newcombe's.
UnadjustedTest fisher(Values first, Values second, double alpha);
// Returns McNemar's exact test of paired values 0 and 1 (Psychometrika 12 (1947) 153). The interval is Newcombe's with
// the corrected correlation.
UnadjustedTest mcnemar(Values first, Values second, double alpha);

}  // namespace ikbench::judge
