// The results of all methods for one set of observations, as numbers. The plan chose beforehand which one decides
// (results/analysis_plan.hpp); assessment.hpp writes the words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/finding.hpp"
#include "analysis/inference/observations.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::inference {

struct Method;

struct GroupEvidence {
  std::string name;
  statistics::Description described = {};
  Estimate mean = {};    // interval of Student's t
  Estimate median = {};  // distribution-free interval by order statistics
  double q1 = statistics::not_defined;
  double q3 = statistics::not_defined;
  double mean_rank = statistics::not_defined;  // among all values, 1 is best; not defined for summaries
  double decades = statistics::not_defined;    // decades that the single values span (statistics::decades)
  int copies = 0;                              // Group::copies
  std::size_t bits = 0;                        // Group::bits
};

// paper: the usual analysis of papers. robust: needs fewer assumptions.
enum class Role { paper, robust };

struct TestResult : statistics::Test {
  std::string test;
  std::string symbol = {};  // of the statistic: "F", "H"
  Role role = Role::robust;
  std::string effect_symbol = {};
  double effect = statistics::not_defined;
  bool decides = false;      // it goes with the method that decides the pairs
  std::string without = {};  // names the groups that it had to leave out
};

struct Evidence {
  std::string name, quantity, unit = {};
  Better better = Better::smaller;
  // log10: tests use logarithms. Results are in the quantity's unit: means are geometric, a difference is the ratio
  // first / second; standard deviations stay those of the logarithms. Outcomes are shares.
  ValueScale scale = ValueScale::plain;
  std::string replicate = {}, block = {}, block_noun = "blocks";
  std::size_t blocks = 0;
  bool from_summaries = false;
  std::vector<std::string> notes = {};
  Doubts flaws = {};
  double margin = 0;                // absolute, in the quantity's unit: the plan's (cm) or the observations' own
  results::AnalysisPlan plan = {};  // its test is the one that decides, never by_design
  const Method* method = nullptr;   // the method that decides (method.hpp)
  bool of_outcomes = false;         // every observation is 0 or 1, so a group's mean is a share (outcomes.hpp)
  bool constant = false;            // every group has one value only, and the values are no outcomes
  std::vector<GroupEvidence> groups = {};
  std::vector<TestResult> tests = {};  // in the order of Role
  // Pairs with first < second, in order. With a control or more than most_groups_in_pairs groups, only pairs with the
  // group `reference`.
  std::vector<Finding> contrasts = {};
  std::optional<std::size_t> reference = {};
  std::size_t pairs = 0;  // number of pairs of all groups
  int fewest = 0;         // fewest per group (or blocks) to tell a pair apart; 0 if means decide: two suffice

  const TestResult* test(std::string_view test_name) const;  // null if it was not made
  bool ranks_decide() const;
  // Returns whether the deciding method compares differences within blocks.
  bool decides_within_blocks() const;
  // Number of pairs that p-values and intervals are corrected for: those with the control, else all.
  std::size_t family() const { return plan.control.empty() ? pairs : groups.size() - 1; }
  // The significance of one pair by itself if that of the family is the plan's (Bonferroni).
  double alpha() const { return plan.significance / static_cast<double>(family()); }
};

// The difference of equal groups: 0, or the ratio 1 on a log10 scale.
constexpr double no_difference(const Evidence& evidence) { return evidence.scale == ValueScale::log10 ? 1 : 0; }

// Throws std::invalid_argument if the control is no group, or the deciding test does not fit the data (ranks from
// summaries).
Evidence evidence(const Observations& observations, const results::AnalysisPlan& plan);
// Describes the groups only: no tests.
Evidence described(const Observations& observations, const results::AnalysisPlan& plan);

// Reduces a plan to what the data allow: no ranks and no control for summaries, no control
// that is no group.
results::AnalysisPlan feasible(results::AnalysisPlan plan, const Observations& observations);

// Names of the tests of all groups.
constexpr std::string_view anova_name = "One-way ANOVA", welch_name = "Welch's ANOVA",
                           kruskal_wallis_name = "Kruskal-Wallis test";

}  // namespace ikbench::inference
