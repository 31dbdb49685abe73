// Welch's test: do two groups of unequal variance have the same mean? (Welch, Biometrika 34 (1947) 28)
#pragma once

#include <string>

#include "analysis/anova.hpp"

namespace ikbench {

struct WelchTest {
  double t = not_defined;
  double df = not_defined;  // Welch-Satterthwaite
  double p = not_defined;   // two-sided
  std::string undefined;    // why there is no p; empty where there is
};

WelchTest welch(const GroupSummary& a, const GroupSummary& b);

}  // namespace ikbench
