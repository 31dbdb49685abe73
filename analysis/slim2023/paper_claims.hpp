// The claims of Slim et al. (2023), each judged by the numbers of a study and of its companions.
#pragma once

#include <vector>

#include "analysis/report/paper.hpp"

namespace ikbench::slim2023 {

// Companions: studies of the paper's other experiments. None where nothing is published of them, or nothing is solved.
std::vector<report::Claim> claims(const report::Reported& reported);

}  // namespace ikbench::slim2023
