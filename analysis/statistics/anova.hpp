// One-way analysis of variance, from samples or from published summaries, in the layout of the paper's Tables 4-6.
#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct AnovaTable : Test {  // the statistic is F, p its upper tail, df are between and within the groups
  double ss_between = not_defined;
  double ss_within = not_defined;
  double ss_total = not_defined;
  double ms_between = not_defined;
  double ms_within = not_defined;
};

AnovaTable anova(std::span<const std::vector<double>> groups);
AnovaTable anova_from_summaries(std::span<const GroupSummary> groups);

// Upper tail of the F distribution; NaN if F is not a number or a degree of freedom is missing.
double f_upper_tail(double F, double df_between, double df_within);

}  // namespace ikbench::statistics
