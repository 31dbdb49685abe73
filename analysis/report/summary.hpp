// What a study says, in plain words: the paper's findings and whether they hold here.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/study.hpp"

namespace ikbench::report {

// Sentences, the most important first; plain text.
std::vector<std::string> summary(const inference::StudyResults& study, results::Unit unit);

// How the solvers of another study with the same targets did, in a sentence.
std::string perspective(const inference::StudyResults& other, results::Unit unit);

}  // namespace ikbench::report
