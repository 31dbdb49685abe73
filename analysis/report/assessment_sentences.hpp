// The words of an assessment: what a good reviewer would ask, answered in order.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::report {

std::vector<std::string> sentences_of(const inference::Evidence& evidence);
// Those that a summary takes.
std::vector<std::string> headlines_of(const inference::Evidence& evidence);

}  // namespace ikbench::report
