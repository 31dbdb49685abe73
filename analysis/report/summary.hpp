// What a study says, in plain words.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/ranking.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/paper.hpp"

namespace ikbench::report {

// Sentences, the most important first; plain text. What a paper says of a study stands between what every study says.
std::vector<std::string> summary(const Reported& reported, const Paper& paper);

// Whose paper, what was run, and what of the paper was not: a sentence each.
std::vector<std::string> studied(const inference::StudyResults& study, const Paper& paper);

// Of what a summary is made; empty where there is nothing to say.
// The solvers that have a mean of the metric.
std::vector<inference::Standing> standings(const inference::StudyResults& study, inference::Metric metric);
std::string ranking_sentence(const inference::StudyResults& study, inference::Metric metric);
// Who claimed an error that the verifier does not find, and how often.
inference::Doubts wrong_claims(const inference::StudyResults& study);
std::string limits_sentence(const inference::StudyResults& study);
// Why times are not ranked.
std::string times_sentence(const inference::StudyResults& study);

// How the solvers of another study with the same targets did, in a sentence.
std::string baselines_sentence(const inference::StudyResults& other);

}  // namespace ikbench::report
