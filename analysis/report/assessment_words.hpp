// Words numbers, names and lists for the sentences of an assessment.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

constexpr std::size_t longest_name_in_text = 60;

std::string p_words(double p);
std::string at_most(double p);                   // two digits, rounded up
std::string against(double mean, double other);  // "0.0019 vs 0.365", with enough digits to tell them apart
std::string listed(
    const std::vector<std::string>& items);  // "a, b and c"; of a long list the first items and the number of the rest
std::string clauses(const std::vector<std::string>& items);  // the same for clauses that contain commas
std::string name_words(const inference::Evidence& evidence, std::size_t group);  // in quotes if it would break a list
std::string pair_words(const inference::Evidence& evidence, const inference::Finding& contrast);  // "IK-BA vs DE"

// The words for a difference, which sentences, tables and JSON share.
std::string margin_words(const inference::Evidence& evidence);  // "5 %", "5 % or 0.01 cm"
// The larger of the two margins, which counts for the pair.
std::string margin_words(const inference::Evidence& evidence, const inference::Finding& contrast);
// Limits of a difference's interval without sign; for a ratio, how many times as large the larger is.
std::pair<double, double> interval_sizes(const inference::Evidence& evidence, const inference::Finding& contrast);
// Compares the difference of a pair with the margin: "more than 5 %", "less than 5 %", "3 % to 12 % (margin 5 %)".
// Empty if the interval does not favour the better one, or the plan has no margin.
Clause extent_clause(const inference::Evidence& evidence, const inference::Finding& contrast);
// "IK-BA is better by more than 5 %", "the same within 5 %", "undecided", "not defined: ..."
std::string verdict_words(const inference::Evidence& evidence, const inference::Finding& contrast);
std::string_view role_words(inference::Role role);            // "assumption", "classical", "robust"
std::int64_t ones_of(const inference::GroupEvidence& group);  // of outcomes
std::string_view replicates_words(
    const inference::Evidence& evidence);  // "observations per group", or the blocks' noun: "targets"
// The observations needed to decide a pair: "it takes 31 to 122 observations per group to see a difference of 5 %"; for
// constants and outcomes "it takes at least 4 ...". Empty if unknown or already reached.
std::string runs_words(const inference::Evidence& evidence, const inference::Estimate& runs);
// Observations needed by these pairs: the least and the most.
inference::Estimate runs_of_all(const std::vector<const inference::Finding*>& pairs);
// For pairs that are the same or better by means: "20 observations per group can miss what happens in up to 14 % of
// them". Empty without such pairs.
std::string rare_failures_words(const inference::Evidence& evidence);
std::string_view adjustment_words(const inference::Evidence& evidence);  // "Holm"
std::string_view none_words(const inference::Evidence& evidence);        // no difference in words: "zero"
// Returns whether ranks decide and there are too few observations to tell any pair apart.
bool has_too_few(const inference::Evidence& evidence);
std::size_t corrected_for(
    const inference::Evidence& evidence);  // number of pairs that deciding p-values are corrected for

bool has_single_values(const inference::Evidence& evidence);  // every group has one observation, or none

// The test of equal variances: Brown and Forsythe's if the values are known, because Bartlett's assumes normal ones.
// Null if neither test was made.
const inference::TestResult* variance_test(const inference::Evidence& evidence);
bool variances_differ(const inference::Evidence& evidence);

}  // namespace ikbench::report
