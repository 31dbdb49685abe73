// Words numbers, names and lists for the sentences of an assessment.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

constexpr std::size_t longest_name_in_text = 60;

std::string p_words(double p);
// The name of a quantity for headings and captions. A time has none of its unit, which is that of its numbers.
std::string quantity_words(const std::string& quantity, std::string_view unit);
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
// Empty if the interval does not favour the better one, or the plan has no margin. The second is a remark.
std::pair<std::string, std::string> extent_words(const inference::Evidence& evidence,
                                                 const inference::Finding& contrast);
// "IK-BA is better by more than 5 %", "the same within 5 %", "undecided", "not defined: ..."
std::string verdict_words(const inference::Evidence& evidence, const inference::Finding& contrast);
std::string_view role_words(inference::Role role);            // "classical", "robust"
std::int64_t ones_of(const inference::GroupEvidence& group);  // of outcomes
std::string_view replicates_words(
    const inference::Evidence& evidence);  // "observations per group", or the blocks' noun: "targets"
// For pairs that are the same or better by means: "20 observations per group can miss what happens in up to 14 % of
// them". Empty without such pairs.
std::string rare_failures_words(const inference::Evidence& evidence);
// Says that too few observations exist for any pair to differ; empty if there are enough.
Sentence too_few(const inference::Evidence& evidence);
std::size_t corrected_for(
    const inference::Evidence& evidence);  // number of pairs that deciding p-values are corrected for

bool has_single_values(const inference::Evidence& evidence);  // every group has one observation, or none

// The answer of an evidence from its pairs: who is better than whom, by how much, and how sure.

// The sentences, without their full stops, on the best group (or the control) against the others; then which other
// pairs differ, and which test decided. Empty if there is nothing to compare.
std::vector<std::string> answer(const inference::Evidence& evidence);
// The same without amounts, reasons and other pairs; `label` names a group: "IK-BA (0.0017 cm)".
std::vector<std::string> short_answer(const inference::Evidence& evidence,
                                      const std::function<std::string(std::size_t group)>& label);
// Returns whether a pair is judged: better, worse, same or undecided.
bool has_judged(const inference::Evidence& evidence);
std::string decided_by(const inference::Evidence& evidence);  // each deciding test once, the planned one first

// "What would change it: a larger new study ...": names the choices or data that could change the answer. Empty if no
// pair is compared.
// `tells_extent`: the answer also says by how much, which depends on the margin.
Sentence change_words(const inference::Evidence& evidence, bool tells_extent = true);

}  // namespace ikbench::report
