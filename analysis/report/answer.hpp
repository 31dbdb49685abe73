// Words the answer of an evidence from its pairs: who is better than whom, by how much, and how sure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// The sentences, without their full stops, on the best group (or the control) against the others; then which other
// pairs differ, and which test decided. Empty if there is nothing to compare.
std::vector<std::string> answer(const inference::Evidence& evidence);
// The same without amounts, reasons and other pairs; `label` names a group: "IK-BA (0.0017 cm)".
std::vector<std::string> short_answer(const inference::Evidence& evidence,
                                      const std::function<std::string(std::size_t group)>& label);
// Returns whether a pair is judged: better, worse, same or undecided.
bool has_judged(const inference::Evidence& evidence);

// "What would change it: a larger new study ...": names the choices or data that could change the answer. Empty if no
// pair is compared.
// `tells_extent`: the answer also says by how much, which depends on the margin.
Sentence change_words(const inference::Evidence& evidence, bool tells_extent = true);

}  // namespace ikbench::report
