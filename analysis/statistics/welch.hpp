// Welch's tests of groups of unequal variance: have two the same mean (Biometrika 34 (1947) 28), or several?
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/anova.hpp"

namespace ikbench {

struct WelchTest {
  double t = not_defined;
  double df = not_defined;  // Welch-Satterthwaite
  double p = not_defined;   // two-sided
  std::string undefined;    // why there is no p; empty where there is
};

WelchTest welch(const GroupSummary& a, const GroupSummary& b);

// Welch's analysis of variance: do groups of unequal variances have the same mean? (Biometrika 38 (1951) 330)
struct WelchAnova {
  double F = not_defined;
  double df_between = not_defined;
  double df_within = not_defined;
  double p = not_defined;  // not defined where a group has fewer than two values or no spread, or is alone
};

WelchAnova welch_anova(std::span<const GroupSummary> groups);

}  // namespace ikbench
