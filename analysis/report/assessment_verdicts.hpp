// Who differs from whom: the words for the pairs of an assessment.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::report {

// The answer: of the best group (or the control), who is worse, by how much, and how sure that is; who is the same, and
// who undecided; which of the other pairs differ, and what decided. Empty where there is nothing to compare.
std::string in_short(const inference::Evidence& evidence);
std::vector<std::string> who_differs(const inference::Evidence& evidence);

}  // namespace ikbench::report
