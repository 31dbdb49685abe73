// What a study says, in plain words: the paper's findings and whether they hold here.
#pragma once

#include <string>
#include <vector>

#include "analysis/study.hpp"

namespace ikbench {

// Sentences, the most important first; plain text.
std::vector<std::string> summary(const StudyResults& study, Unit unit);

// How the solvers of another study with the same targets did, in a sentence.
std::string perspective(const StudyResults& other, Unit unit);

}  // namespace ikbench
