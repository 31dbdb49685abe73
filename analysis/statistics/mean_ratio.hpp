// Two means compared by their ratio, with a margin: is b slower than a by more than 5 %, or the same within 5 %?
// One-sided t-tests of mean(b) - theta mean(a) (Sasabuchi, Biometrika 67 (1980) 429) with Welch's degrees of freedom
// (Tamhane and Logan, Biometrical J. 46 (2004) 3), or of the pairs b_i - theta a_i.
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct RatioQuestion {
  double margin = 0.05;        // 0 <= margin < 1
  double level = 0.95;         // of the interval
  double absolute_margin = 0;  // of mean(b) - mean(a), beside the relative one
};

// The tests have p-values of their own kind: p_above is small where the ratio is above 1 + margin, p_below where it is
// below 1 - margin, p_equivalent where it is between the two, p_difference where it is not 1. With an absolute margin
// the difference also has to be above or below that: p_above and p_below are the larger of two p (Berger, Technometrics
// 24 (1982) 295). Within either margin is within, so p_equivalent is the smaller: its error is at most that of the
// larger margin's test unless the two are about equal, and then that of two tests that nearly always agree. Where the
// mean of a is not positive, the absolute margin alone is tested.
struct RatioComparison {
  double ratio = not_defined;  // mean of b / mean of a
  double low = not_defined;    // Fieller's interval: the ratios that the one-sided tests at (1 - level) / 2 leave
  double high = not_defined;   // NaN both where it has no bounds: the mean of a is not told from 0
  double p_difference = not_defined;  // two-sided
  double p_above = not_defined;       // H0: ratio <= 1 + margin, or the difference <= the absolute margin
  double p_below = not_defined;       // H0: ratio >= 1 - margin, or so
  double p_equivalent = not_defined;  // the larger p of H0: ratio >= 1 + margin and H0: ratio <= 1 - margin
  double df = not_defined;            // of p_difference
  std::string exact;                  // why the p's are facts, 0 or 1, and not chances; empty where they are chances
  std::string
      undefined;  // why there is no ratio (p of differences can still be there) or nothing; empty where there is
};

// Of independent samples, and of pairs in order (std::invalid_argument where they are not equally many).
RatioComparison mean_ratio(std::span<const double> a, std::span<const double> b, const RatioQuestion& question);
RatioComparison paired_mean_ratio(std::span<const double> a, std::span<const double> b, const RatioQuestion& question);

}  // namespace ikbench::statistics
