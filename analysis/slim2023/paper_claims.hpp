// The claims of Slim et al. (2023), each judged by the numbers of a study and of its companions.
#pragma once

#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/claims.hpp"

namespace ikbench::slim2023 {

// Companions: studies of the paper's other experiments. None where nothing is published of them, or nothing is solved.
std::vector<report::Claim> claims(const inference::StudyResults& study,
                                  const std::vector<inference::StudyResults>& companions);

}  // namespace ikbench::slim2023
