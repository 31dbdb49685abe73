// Omnibus tests: does any group differ from the others? Articles print them beside the verdicts of pairs; no verdict
// rests on them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/statistics/descriptives.hpp"

namespace ikbench::judge {

// What assumes no equal spreads has no sums of squares.
struct OmnibusTest {
  std::string_view name;
  double statistic = unknown;  // F
  double df = unknown, df_within = unknown;
  double p = unknown;
  double ss_between = unknown, ss_within = unknown;  // within: of blocks the error, group x block
  double epsilon = unknown;  // of blocks: how far the spreads of differences are alike, 1 / (k - 1) to 1

  // Of blocks it is called partial, since the share of the blocks is left out.
  double eta_squared() const { return ss_between / (ss_between + ss_within); }
};

// One-way, of paired groups that of repeated measures (Fisher 1925), which assume equal spreads. None for fewer than
// two groups, copies, lost or infinite values, or groups without spread. Then the same without that: one-way Welch's F
// (Biometrika 38 (1951) 330), not where a group has no spread; of more than two paired groups with the degrees of
// freedom of Greenhouse and Geisser (Psychometrika 24 (1959) 95).
std::vector<OmnibusTest> anova(const MetricSamples& samples);
// Nemenyi's, of mean ranks of so many groups at 0.05 (Demsar, J. Machine Learning Research 7 (2006) 1). NaN for fewer
// than 2 and more than 20 groups.
double critical_difference(std::size_t groups, std::size_t blocks);
// These, of the groups with chance in their values, and the names of the others; none of shares and of
// logarithms.
struct OmnibusTests {
  std::vector<OmnibusTest> tests = {};
  std::vector<std::string> without = {};
};
OmnibusTests omnibus_tests(MetricSamples samples);

}  // namespace ikbench::judge
