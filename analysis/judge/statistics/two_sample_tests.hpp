// Tests of two groups. p is two-sided and of this pair alone; an interval has the level 1 - alpha.
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

struct Interval {
  double low = 0, high = 0;
  bool excludes_low = false, excludes_high = false;  // "above 0", "below 1"
};

// Of first - second.
struct UnadjustedTest {
  double estimate = 0;
  double p = 1;
  int direction = 0;                      // 1: the first is larger, -1: the second
  std::optional<Interval> interval = {};  // none where so few values, or values without spread, give none
};

double critical_z(double alpha);  // of the normal distribution, two-sided

// Two passes, shifted by the first value. sd is 0 if it is rounding. Needs a value.
SummaryStatistics summarise(Values values);

// Values that rise, each with its place. Pairs stay in the cache, which places alone would not.
using IndexedValue = std::pair<double, std::size_t>;
std::vector<IndexedValue> sorted_with_index(Values values);

// The smallest p that ranks and McNemar's test can give.
double min_p_unpaired(std::size_t m, std::size_t n);  // 2 / C(m + n, m)
double min_p_paired(std::size_t n);                   // 2^(1 - n)

// By order statistics of values that rise, whatever they are of; none if there are too few (of the 95 % quantile, at
// 95 %, 72).
std::optional<Interval> quantile_interval(Values sorted, double share, double alpha = 0.05);

// Numbers, unpaired.

// Of sorted values, the first less a shift, by Student's t (Biometrical J. 42 (2000) 17). Without variance the groups
// do not overlap, p = 0, or are equal, 1.
double brunner_munzel(Values first, Values second, double shift = 0);
// Exact, ties and all, to m + n = 100; then normal, corrected for ties and continuity (Annals of Mathematical
// Statistics 18 (1947) 50).
double mann_whitney(Values first, Values second);
// The larger p of the two, with Hodges and Lehmann's shift (Annals of Mathematical Statistics 34 (1963) 598). The
// interval has the shifts that either test keeps, Mann-Whitney as if without ties.
UnadjustedTest rank_test(Values first, Values second, double alpha);
// Values that are made of a sum may be worth fewer: so many less one are the degrees of freedom, if they are at
// least 1.
constexpr double unlimited = std::numeric_limits<double>::infinity();
// Biometrika 34 (1947) 28. Two constant groups have the p of the permutations, 2 / C(m + n, m).
UnadjustedTest welch(const SummaryStatistics& first, const SummaryStatistics& second, double alpha,
                     double worth = unlimited);

// Numbers, paired: by the differences first - second.

// Wilcoxon's signed ranks (Biometrics 1 (1945) 80), exact to n = 1000; differences of 0 have no rank. The estimate is
// the median of all means of two differences.
UnadjustedTest signed_rank_test(Values differences, double alpha);
// Student's t (Biometrika 6 (1908) 1). Equal differences have the p of the permutations, 2^(1 - n).
UnadjustedTest t_test(Values differences, double alpha, double worth = unlimited);
// The signs of the differences that are not 0 (Dixon and Mood, JASA 41 (1946) 557); the median, with the interval of
// its order statistics.
UnadjustedTest sign_test(Values differences, double alpha);

// Shares.

// JASA 22 (1927) 209; `share` may be a mean of shares.
Interval wilson_interval(double share, double n, double alpha);
// Statistics in Medicine 17 (1998) 873, method 10; for correlated shares 2635, method 10.
Interval newcombe_interval(double first, double m, double second, double n, double alpha, double correlation = 0);
// Of values 0 and 1. All tables no more probable than this one (Fisher, Statistical Methods for Research Workers, 5th
// ed. 1934, section 21.02); Newcombe's interval.
UnadjustedTest fisher(Values first, Values second, double alpha);
// The same of pairs, exact (Psychometrika 12 (1947) 153); Newcombe's interval with the corrected correlation.
UnadjustedTest mcnemar(Values first, Values second, double alpha);

}  // namespace ikbench::judge
