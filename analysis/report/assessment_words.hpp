// What the sentences of an assessment share: numbers, names and lists as words.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::report {

constexpr std::size_t longest_name_in_text = 60;

std::string number_words(double value);  // three digits, and all digits before the point
std::string p_words(double p);
std::string listed(const std::vector<std::string>& items);   // "a, b and c"; of many the first, and how many more
std::string clauses(const std::vector<std::string>& items);  // the same of clauses that have commas themselves
std::string name_words(const inference::Evidence& evidence, std::size_t group);
std::string pair_words(const inference::Evidence& evidence, const inference::Contrast& contrast);
std::string flaw_words(const inference::Evidence& evidence);  // of one that has a flaw

// Whether equal variances are refuted: by Brown and Forsythe's test where the values are there, since Bartlett's takes
// normal ones for granted. Null where neither test was made.
const inference::TestResult* variance_test(const inference::Evidence& evidence);
bool variances_differ(const inference::Evidence& evidence);
// So far that a pooled variance is that of the most variable group alone.
bool pooling_misleads(const inference::Evidence& evidence);

}  // namespace ikbench::report
