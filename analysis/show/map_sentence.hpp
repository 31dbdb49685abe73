// The answer of a study of a grid: which solver reaches which of its poses. A grid is no random sample, so the answer
// only counts. `make_report_model` takes the sentence as the headline.
#pragma once

#include <string>
#include <vector>

#include "analysis/judge/judge.hpp"

namespace ikbench::show {

// Returns "LM and DLS reach all 824 poses that any solver reaches; Newton misses 2 and KDL 523. Tool down, plane y = 0,
// steps of 5 cm; 228 others, perhaps out of reach, are solved by none." Solvers are in the order of `solvers`.
std::string map_sentence(const judge::JudgedStudy& judged, const std::vector<std::string>& solvers);
// Returns what a page says below the table: that nothing is tested, how many targets were left out, and which solvers
// have a limit of their own.
std::vector<std::string> map_notes(const judge::StudyResults& study);

}  // namespace ikbench::show
