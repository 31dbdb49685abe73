// What the sentences of an assessment share: numbers, names and lists as words.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

constexpr std::size_t longest_name_in_text = 60;

std::string p_words(double p);
std::string at_most(double p);                              // two digits, and no less than it is
std::string against(double mean, double other);             // "0.0019 vs 0.365", with as many digits as tell them apart
std::string listed(const std::vector<std::string>& items);  // "a, b and c"; of many the first, and how many more
std::string clauses(const std::vector<std::string>& items);  // the same of clauses that have commas themselves
std::string name_words(const inference::Evidence& evidence, std::size_t group);  // in quotes where a list would break
std::string pair_words(const inference::Evidence& evidence, const inference::Contrast& contrast);  // "IK-BA vs DE"

// The words for a difference, which sentences, tables and JSON share.
std::string margin_words(const inference::Evidence& evidence);  // "5 %", "5 % or 0.01 cm"
// The larger one, which holds for the pair.
std::string margin_words(const inference::Evidence& evidence, const inference::Contrast& contrast);
// The limits of the interval of a difference without its sign; of a ratio how many times as much the larger is.
std::pair<double, double> interval_sizes(const inference::Evidence& evidence, const inference::Contrast& contrast);
// Of a pair that differs, against the margin: "more than 5 %", "less than 5 %", "3 % to 12 % (margin 5 %)". Empty where
// the interval is not for the better one, or the plan has no margin.
Clause extent_clause(const inference::Evidence& evidence, const inference::Contrast& contrast);
// "IK-BA is better by more than 5 %", "the same within 5 %", "undecided", "not defined: ..."
std::string verdict_words(const inference::Evidence& evidence, const inference::Contrast& contrast);
std::string_view replicates_words(
    const inference::Evidence& evidence);  // "observations per group", or what blocks are: "targets"
// Of a pair that is undecided: "it takes 31 to 122 observations per group to see a difference of 5 %", of constants and
// outcomes "it takes at least 4 ..."; empty where it is not known, or there are as many.
std::string runs_words(const inference::Evidence& evidence, const inference::Estimate& runs);
// What each of these takes, at least and at most.
inference::Estimate runs_of_all(const std::vector<const inference::Contrast*>& pairs);
// Of pairs that are the same or better by means: "20 observations per group do not exclude a failure in up to 14 % of
// them". Empty where there are none.
std::string rare_failures_words(const inference::Evidence& evidence);
std::string_view adjustment_words(const inference::Evidence& evidence);  // "Holm"
std::string_view none_words(const inference::Evidence& evidence);        // of no difference: "zero"
// Where ranks decide: whether there are so few observations that no pair can be told apart, whatever they are.
bool has_too_few(const inference::Evidence& evidence);
std::size_t corrected_for(const inference::Evidence& evidence);  // so many pairs the deciding p-values are

bool has_single_values(const inference::Evidence& evidence);  // every group has one observation, or none

// Whether equal variances are refuted: by Brown and Forsythe's test where the values are there, since Bartlett's takes
// normal ones for granted. Null where neither test was made.
const inference::TestResult* variance_test(const inference::Evidence& evidence);
bool variances_differ(const inference::Evidence& evidence);

}  // namespace ikbench::report
