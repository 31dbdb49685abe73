// Omnibus tests: does any group differ from the others? Articles print these tests beside the verdicts of pairs; no
// verdict rests on them. docs/explanation/methods.md says when they are left out.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/statistics/descriptives.hpp"

namespace ikbench::judge {

// A test of all groups. Tests that do not assume equal spreads, and tests of ranks, leave the sums of squares unknown
// (NaN).
struct OmnibusTest {
  std::string_view name;
  double statistic = unknown;                // F; of Friedman's test chi-squared
  double df = unknown, df_within = unknown;  // Friedman's test has no degrees of freedom within
  double p = unknown;
  double ss_between = unknown;
  double ss_within = unknown;  // with blocks: error, group x block
  double epsilon = unknown;    // with blocks: how far the spreads of differences are alike, 1 / (k - 1) to 1

  // Returns the share of the groups in the sum of squares. With blocks it is a partial share, without that of the
  // blocks.
  double eta_squared() const { return ss_between / (ss_between + ss_within); }
};

// Returns the analysis of variance of all groups (Fisher 1925), one-way or, for paired groups, of repeated measures,
// and then the same test without the assumption of equal spreads: one-way Welch's F (Biometrika 38 (1951) 330), unless
// a group has no spread; for more than two paired groups the degrees of freedom of Greenhouse and Geisser
// (Psychometrika 24 (1959) 95). Empty for fewer than two groups, copies, missing or infinite values, or if no group has
// a spread.
std::vector<OmnibusTest> anova(const MetricSamples& samples);
constexpr std::string_view friedman_name = "Friedman's test", iman_davenport_name = "Iman-Davenport";
// Returns Friedman's test of the ranks in the blocks that all groups have, corrected for ties (Friedman, J. Am. Stat.
// Assoc. 32 (1937) 675), and the F of Iman and Davenport (Comm. Statist. A9 (1980) 571), which Demsar (J. Machine
// Learning Research 7 (2006) 1) puts first. Of proportions with one trial it is Cochran's Q. Empty for costs per
// success, unpaired samples, fewer than three groups or two blocks, missing values, or if all values of each block are
// equal.
std::vector<OmnibusTest> friedman(const MetricSamples& samples);
// Returns the p of Friedman's test of groups with the same blocks, in the same order; 1 if all values of each block are
// equal.
double friedman_p(const std::vector<std::span<const double>>& groups);
// Returns Nemenyi's critical difference of mean ranks at 0.05 (Demsar, J. Machine Learning Research 7 (2006) 1). NaN
// for fewer than 2 and for more than 20 groups.
double critical_difference(std::size_t groups, std::size_t blocks);
// The analyses of variance of the groups that have chance in their values.
struct OmnibusTests {
  std::vector<OmnibusTest> tests = {};
  std::vector<std::string> without = {};  // names of the groups that are left out
};
// Returns no tests for proportions and for logarithms of costs.
OmnibusTests omnibus_tests(MetricSamples samples);

}  // namespace ikbench::judge
