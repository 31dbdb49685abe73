// The methods that decide which of two groups is better, as a table: one row for each (methods/), which says what the
// method compares, how, and after whom. The plan and the design choose the row, never the data.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "results/deciding_tests.hpp"

namespace ikbench::inference {

// The groups that are compared. Where only their summaries are known there are no values.
struct Groups {
  std::span<const statistics::GroupSummary> summaries;
  std::span<const std::vector<double>> values;  // what is not a number ranks last; with blocks in their order
  std::span<const std::vector<double>> ranked;  // the same, the smaller the better
};

// What a method says of one pair.
struct PairResult {
  double p = statistics::not_defined;        // corrected for the whole family
  double p_alone = statistics::not_defined;  // of this pair alone
  int ahead = 0;                             // 1 where the first is ahead, -1 where the second is
  Estimate difference = {};                  // of means or shares, first - second
  std::string undefined = {};                // why there is no p
};

enum class Compares { means, ranks, shares };

struct Method {
  std::string_view name;      // as a plan names it; a plan cannot name the two methods of shares
  std::string_view title;     // of the test of all groups with that of its pairs
  std::string_view of_pair;   // "Tukey's test"
  std::string_view of_two;    // the same where there are two groups: "Student's test"
  std::string_view interval;  // by which method a difference has its interval
  std::string_view source;
  Compares compares = Compares::means;
  bool within_blocks = false;       // it looks at the differences within blocks
  bool corrects_all_pairs = false;  // p is corrected for the pairs of all groups, also where there is a control
  // It draws resamples, which a few equal values do not have: an exact test of order then takes its place.
  bool resamples = false;
  // In the order of Evidence::contrasts, whose groups are those to compare.
  std::vector<PairResult> (*pairs)(const Evidence& evidence, const Groups& groups) = nullptr;
  // The test of all groups; none where the method has none.
  std::optional<TestResult> (*all)(const Evidence& evidence, const Groups& groups) = nullptr;
};

// Every row: those that a plan can name, in the order of results/deciding_tests.inc, then the variants of the bootstrap
// within blocks, then those of shares.
std::span<const Method* const> methods();

// The row that decides, by the test of the plan and what the groups are: outcomes, in blocks, more values than a
// bootstrap can draw again in a second, or summaries alone. std::invalid_argument where the plan's test needs what the
// groups do not have.
const Method& method_for(const Evidence& evidence);
// What a plan's test compares; by_design: means.
Compares compares(std::string_view test);

// The test of ranks that is shown beside a test of means: within blocks if there are any.
const Method& rank_method(const Evidence& evidence);

// The analysis of variance, which papers make.
const Method& paper_method();

// Corrects p-values as planned. A pair of the family that is not among these, or has no p, counts as one that does not
// differ.
void correct(const Evidence& evidence, std::vector<double>& p);
// The same of results that have p_alone: fills p.
void correct(const Evidence& evidence, std::vector<PairResult>& pairs);

// What the rows share.
std::vector<PairResult> of_means(const Evidence& evidence, const std::vector<statistics::MeanDifference>& differences);
// How many times the bootstrap can draw so many values; 0 where they are too many.
int resamples_of(const Evidence& evidence);
std::optional<TestResult> welch_of_all(const Evidence& evidence, const Groups& groups);

}  // namespace ikbench::inference
