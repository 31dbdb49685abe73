// Who differs from whom: the words for the pairs of an assessment.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// Of the best group (or the control), who is worse, by how much, and how sure that is; who is the same, and who
// undecided; which of the other pairs differ, and what decided. Empty where there is nothing to compare.
struct InShort {
  std::vector<std::string> sentences = {};  // without their full stops; the first is the answer
};
InShort in_short(const inference::Evidence& evidence);
std::string words_of(const InShort& in_short);
std::vector<Sentence> who_differs(const inference::Evidence& evidence);

}  // namespace ikbench::report
