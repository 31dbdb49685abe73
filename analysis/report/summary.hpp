// Summarises a study in plain words.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/paper.hpp"

namespace ikbench::report {

// Sentences, the most important first; plain text. Those of the paper follow the rankings.
std::vector<std::string> summary(const Reported& reported, const Paper& paper);

// One sentence each: whose paper, what was run, and what of the paper was not.
std::vector<std::string> studied(const inference::StudyResults& study, const Paper& paper);

// The parts of a summary follow; each is empty if there is nothing to say.
std::string ranking_sentence(const inference::StudyResults& study, inference::Metric metric);
// Doubts of solvers that claimed an error which the verifier does not confirm, and how often.
inference::Doubts wrong_claims(const inference::StudyResults& study);
std::string limits_sentence(const inference::StudyResults& study);
// Says why times are not ranked.
std::string times_sentence(const inference::StudyResults& study);

}  // namespace ikbench::report
