// Everything that the methods say of one set of observations, as numbers. Which of them decides was chosen before
// (results/analysis_plan.hpp); the words are assessment.hpp's.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/finding.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/inference/relation.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::inference {

struct Method;

struct GroupEvidence {
  std::string name;
  statistics::Description described = {};
  Estimate mean = {};          // interval of Student's t
  Estimate bootstrapped = {};  // of the mean, by the studentized bootstrap
  Estimate median = {};        // interval by order statistics, free of a distribution
  double q1 = statistics::not_defined;
  double q3 = statistics::not_defined;
  double normality = statistics::not_defined;  // p of Shapiro and Wilk's test
  double normality_w = statistics::not_defined;
  double mean_rank = statistics::not_defined;     // of all values together, 1 is best; only where there are values
  double average_rank = statistics::not_defined;  // over the blocks, 1 is best; only where there are blocks
  double decades = statistics::not_defined;       // what the single values span (statistics::decades)
  int copies = 0;                                 // Group::copies
};

// assumption: what a test takes for granted. paper: the analysis that the paper made. robust: what needs less.
enum class Role { assumption, paper, robust };

struct TestResult {
  std::string test;
  bool decides = false;      // it goes with the method that decides the pairs
  std::string without = {};  // groups that it had to leave out, in words
  Role role = Role::robust;
  std::string symbol = {};  // of the statistic: "F", "H"
  double statistic = statistics::not_defined;
  double df = statistics::not_defined;
  double df_within = statistics::not_defined;  // only where there are two
  double p = statistics::not_defined;
  std::string effect_symbol = {};
  double effect = statistics::not_defined;
  std::string undefined = {};  // why there is no p
};

// Where the whole interval of a difference lies, against the margin of the plan. across: it is for the better one, on
// both sides of the margin. unknown: there is no such interval, or it is not for the better one.
enum class Extent { unknown, within, across, beyond };
std::string_view name_of(Extent extent);

struct Contrast {
  std::size_t first = 0, second = 0;
  Estimate difference = {};            // mean of first - mean of second (Evidence::scale), simultaneous over all pairs
  double p = statistics::not_defined;  // of the deciding test, corrected for all pairs
  double p_alone = statistics::not_defined;  // of that test, of this pair alone
  // The two do not overlap, and an exact test of ranks decides (within blocks, or against a value that is known, the
  // sign test), because the bootstrap has no spread to judge by, or a group has one value alone.
  bool is_by_order = false;
  bool is_fact =
      false;      // both values are known (Group::copies), so that no chance is in the relation, and there is no p
  int ahead = 0;  // the sign of that test's own statistic: 1 where it is for first, -1 for second
  // Of the test of ranks that is shown beside a test of means (rank_method), corrected as planned, and for whom it is.
  double p_ranks = statistics::not_defined;
  int ahead_by_ranks = 0;
  Estimate superiority = {};  // A12: the chance that an observation of first is better than one of second
  // Where ranks decide, and all values have one sign: the typical ratio of first by second, below 1 where first is
  // smaller. Within blocks it is the
  // median of their ratios, with order statistics as its interval, which is that of the sign test; else Hodges and
  // Lehmann's, with the interval of Mann and Whitney's test.
  Estimate ratio = {};
  double g = statistics::not_defined;  // Hedges; positive where the mean of first is larger
  // Of a pair that is undecided: observations a group, or blocks, with which a difference of the margin is found with
  // the planned power where values spread as they do here, and as they plausibly do; no fewer than the test needs.
  Estimate runs_to_decide = {};
  Relation relation = Relation::undefined;
  Extent extent = Extent::unknown;
  std::string undefined = {};  // why p is not defined
};

// Whether one of the two is better.
inline bool is_decided(const Contrast& contrast) { return is_difference(contrast.relation); }

struct Evidence {
  std::string name, quantity, unit = {};
  Better better = Better::smaller;
  // log10: tests are of the logarithms. What is told is in the quantity's unit: means are geometric, a difference is
  // the ratio first by second; standard deviations are of the logarithms.
  ValueScale scale = ValueScale::plain;
  std::string replicate = {}, block = {}, block_noun = "blocks";
  std::size_t blocks = 0;
  bool from_summaries = false;
  std::vector<std::string> notes = {};
  Doubts flaws = {};
  double margin = 0;                // absolute, in the unit of the quantity: the plan's in cm, or one of its own
  results::AnalysisPlan plan = {};  // its test is never by_design here, but the one that decides
  const Method* method = nullptr;   // that decides (method.hpp)
  bool of_outcomes = false;         // every observation is 0 or 1 (outcomes.hpp): a group's mean is a share
  bool constant = false;            // every group has one value alone, and not as outcomes have
  std::vector<GroupEvidence> groups = {};
  double variance_ratio = statistics::not_defined;  // the largest by the smallest
  std::size_t most_variable = 0, least_variable = 0;
  std::vector<TestResult> tests = {};                    // in the order of Role
  double critical_difference = statistics::not_defined;  // Nemenyi's, of average ranks
  // Pairs first < second in order; where there are more than most_groups_in_pairs groups, or a control, only those with
  // one group, `reference`.
  std::vector<Contrast> contrasts = {};
  std::optional<std::size_t> reference = {};
  std::size_t pairs = 0;  // of all groups
  int fewest = 0;  // observations a group, or blocks, from which a pair can be told apart; 0: means decide, from two on

  const TestResult* test(std::string_view test_name) const;  // null where it was not made
  bool ranks_decide() const;
  // Whether the method that decides looks at the differences within blocks.
  bool decides_within_blocks() const;
  // That p-values and intervals are corrected for: the pairs with the control, else all pairs.
  std::size_t family() const { return plan.control.empty() ? pairs : groups.size() - 1; }
};

constexpr std::size_t most_groups_in_pairs = 20;

// The difference of two that are equal, on its scale.
constexpr double no_difference(const Evidence& evidence) { return evidence.scale == ValueScale::log10 ? 1 : 0; }

// A control that is no group, or a deciding test that the data do not have (Friedman without blocks, ranks from
// summaries) is std::invalid_argument.
Evidence evidence(const Observations& observations, const results::AnalysisPlan& plan);
Evidence evidence(const Summaries& summaries, const results::AnalysisPlan& plan);
// The same without the bootstrap's intervals, which take their time and decide nothing; and with them after all.
Evidence tested(const Observations& observations, const results::AnalysisPlan& plan);
Evidence with_bootstrap(Evidence evidence, const Observations& observations);
// The groups described, no test made, and no bootstrap.
Evidence described(const Observations& observations, const results::AnalysisPlan& plan);

// What of a plan can be followed with these: no blocks, no Friedman; of summaries no ranks, and no control.
results::AnalysisPlan feasible(results::AnalysisPlan plan, const Observations& observations);
results::AnalysisPlan feasible(results::AnalysisPlan plan, const Summaries& summaries);

// The names of the tests of all groups, of which one decides.
constexpr std::string_view anova_name = "One-way ANOVA", welch_name = "Welch's ANOVA",
                           kruskal_wallis_name = "Kruskal-Wallis test", friedman_name = "Friedman's test",
                           brown_forsythe_name = "Brown-Forsythe test of equal variances",
                           bartlett_name = "Bartlett's test of equal variances";

}  // namespace ikbench::inference
