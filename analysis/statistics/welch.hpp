// Tests of means: Welch's for groups of unequal variance, two (Biometrika 34 (1947) 28) or several; Student's for
// pairs, and his interval of a mean (Biometrika 6 (1908) 1).
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/anova.hpp"

namespace ikbench::statistics {

struct WelchTest {
  double t = not_defined;
  double df = not_defined;  // Welch-Satterthwaite
  double p = not_defined;   // two-sided
  std::string undefined;    // why there is no p; empty if there is one
};

WelchTest welch(const GroupSummary& a, const GroupSummary& b);

// Welch's analysis of variance: tests whether groups of unequal variances have the same mean (Biometrika 38 (1951)
// 330).
struct WelchAnova {
  double F = not_defined;
  double df_between = not_defined;
  double df_within = not_defined;
  double p = not_defined;
  std::string undefined;  // why there is no p; empty if there is one
};

WelchAnova welch_anova(std::span<const GroupSummary> groups);

struct PairedTest {
  double difference = not_defined;  // mean of a_i - b_i
  double low = not_defined;
  double high = not_defined;  // interval of that mean
  double t = not_defined;
  double df = not_defined;
  double p = not_defined;  // two-sided
  std::string undefined;   // why there is no p; empty if there is one
};

// The pairs are in order; throws std::invalid_argument if the sizes differ, or `level` is not between 0 and 1.
PairedTest paired_t(std::span<const double> a, std::span<const double> b, double level);

struct MeanInterval {
  double low = not_defined;
  double high = not_defined;
  std::string undefined;  // why there is none; empty if there is one
};

// Student's t interval; for a constant group its one value. Throws std::invalid_argument if `level` is not between 0
// and 1.
MeanInterval mean_interval(const GroupSummary& group, double level);

}  // namespace ikbench::statistics
