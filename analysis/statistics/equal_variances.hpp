// Tests whether several groups have the same variance. Bartlett, Proceedings of the Royal Society A 160 (1937) 268, for
// normal values; Brown and Forsythe, JASA 69 (1974) 364 (Levene's test about the medians), for any.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct Bartlett {
  double chi_squared = not_defined;
  int df = 0;
  double p = not_defined;  // upper tail
  std::string undefined;   // why there is no p; empty if there is one
};

// Every group needs two values or more that are not all equal.
Bartlett bartlett(std::span<const std::vector<double>> groups);
Bartlett bartlett_from_summaries(std::span<const GroupSummary> groups);

struct BrownForsythe {
  double F = not_defined;
  int df_between = 0;
  int df_within = 0;
  double p = not_defined;  // upper tail
  std::string undefined;   // why there is no p; empty if there is one
};

// The analysis of variance of the absolute deviations from the groups' medians. Two values have the same deviation, so
// groups of two have no spread of it.
BrownForsythe brown_forsythe(std::span<const std::vector<double>> groups);

}  // namespace ikbench::statistics
