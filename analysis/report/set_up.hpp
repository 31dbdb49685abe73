// The paragraph "Experimental set-up" of an article about a study.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/paper.hpp"
#include "results/store.hpp"

namespace ikbench::report {

// Sentences: the paper and the kind of reproduction, solvers and arm, targets and starts, limits of a solve, how the
// study is judged, and the machine.
std::vector<std::string> set_up_sentences(const inference::JudgedStudy& study, const Paper& paper,
                                          const std::vector<results::Session>& sessions);

}  // namespace ikbench::report
