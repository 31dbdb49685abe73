// Who differs from whom, and where methods disagree: the words for the pairs of an assessment.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::report {

std::string in_short(const inference::Evidence& evidence);  // empty where there is nothing to compare
std::vector<std::string> who_differs(const inference::Evidence& evidence);
std::string disagreements(const inference::Evidence& evidence);

}  // namespace ikbench::report
