// Words the verdicts on the pairs of an assessment: who differs from whom.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// The answer in short: who is worse than the best group (or the control), by how much, and how sure; who is the same or
// undecided; which other pairs differ; and which test decided. Empty if there is nothing to compare.
struct InShort {
  std::vector<std::string> sentences = {};  // without their full stops; the first is the answer
};
InShort in_short(const inference::Evidence& evidence);
std::string words_of(const InShort& in_short);
std::vector<Sentence> who_differs(const inference::Evidence& evidence);

}  // namespace ikbench::report
