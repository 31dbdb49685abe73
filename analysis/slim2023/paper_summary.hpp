// The summary of a study that is compared with Slim et al. (2023): our numbers beside the printed ones.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/paper.hpp"

namespace ikbench::slim2023 {

// Sentences, the most important first; some may be empty. The study has solves.
std::vector<std::string> paper_summary(const report::Reported& reported);

}  // namespace ikbench::slim2023
