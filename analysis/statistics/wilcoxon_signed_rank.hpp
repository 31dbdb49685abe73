// Are differences symmetric about zero? Wilcoxon's signed-rank test, Biometrics 1 (1945) 80.
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/rank_statistic.hpp"

namespace ikbench::statistics {

struct WilcoxonSignedRank {
  int n = 0;               // differences that are not zero: those that are ranked
  int zeros = 0;           // differences left out of V, as Wilcoxon did
  double V = not_defined;  // the sum of the ranks, by size, of the positive differences
  double p = not_defined;  // two-sided
  int direction = 0;       // 1 where V is above its mean: the differences are above zero; -1 below, 0 at it
  std::string method;      // "exact": n < 50, given the ties; else "normal approximation", corrected for ties and
                           // continuity
  std::string undefined;   // why there is no p; empty where there is
};

WilcoxonSignedRank wilcoxon_signed_rank(std::span<const double> differences);

// Of first - second, pair by pair, without what rounding alone puts between them (rounding.hpp). Equal values differ by
// zero, two infinite ones too. Samples of different sizes have no p.
WilcoxonSignedRank wilcoxon_signed_rank(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
