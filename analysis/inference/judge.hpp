// Decides which of two is better. Claims, summary, tables and `ikbench compare` all ask here. The study's plan decides:
// its test, adjustment, significance and margin. Words the test that decides, and ranks groups by it.
#pragma once

#include <cstddef>
#include <string_view>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/method.hpp"

namespace ikbench::inference {

// The verdict by the p, corrected as planned, for the group that is ahead (1: the first, -1: the second). A found
// difference takes precedence over "within the margin".
Relation relation_of(int ahead, double p, double significance, bool is_within_margin = false);

// Judges two groups by name. Flawed observations (points of one run, times that are not comparable) get no verdict. A
// mean that is not a number is worse than a number, without a test. Throws std::invalid_argument if a group is missing.
Finding judge(const Evidence& evidence, std::string_view first, std::string_view second);

// Judges two groups known by their summaries only. Follows the plan as far as summaries allow.
Finding judge(const statistics::GroupSummary& first, const statistics::GroupSummary& second, Better better,
              const results::AnalysisPlan& plan);

// Fills contrasts, pairs and reference of the evidence.
void add_contrasts(Evidence& evidence, const Groups& groups);

// Returns whether each group has one value only, so that Fisher's exact test (within blocks the sign test) judges them.
bool are_constants(const Evidence& evidence, const Finding& pair);
// Returns whether a group is a value that is known without chance (`copies`).
bool has_known(const Evidence& evidence, const Finding& pair);
// Fewest observations per group (or blocks) at which the test can find a difference at all.
int fewest_to_differ(const Evidence& evidence);

// Names the deciding test of a pair; deciding_words adds the test of all groups that goes with it.
std::string_view pair_test_words(const Evidence& evidence);
std::string_view deciding_words(const Evidence& evidence);
// Names the test of two groups with one value each.
std::string_view test_of_constants_words(const Evidence& evidence);
// A group's score by the deciding method: its mean rank or mean. Smaller is better; infinite if not
// defined.
double group_score(const Evidence& evidence, const GroupEvidence& group);
// Index of the group with the smallest group_score().
std::size_t best_group(const Evidence& evidence);
// The test of all groups that goes with the deciding test of pairs; null if it was not made or does not exist.
const TestResult* deciding_test(const Evidence& evidence);

}  // namespace ikbench::inference
