// Says in plain words who leads, what was run, and how a study is set up.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/report/sentence.hpp"
#include "results/store.hpp"

namespace ikbench::report {

// "Smallest mean error (large errors dominate): IK-BA (0.0017 cm) is better than K-ABC (0.208 cm): p = 0.0003." The
// short answer of the evidence, with each solver's value; a cost shows the size of the errors too. Empty if no solver
// has a value.
Sentence leader_sentence(const inference::JudgedStudy& study, inference::Metric metric, results::Estimand estimand);
// Sentences on what makes all numbers doubtful, on who is better by the study's primary_estimand, and on who leads by
// each of the others, which are exploratory. A study with claims is judged by these.
std::vector<Sentence> own_verdict(const inference::JudgedStudy& study, bool has_claims = false);

// Sentences, the most important first; plain text.
std::vector<std::string> summary(const inference::StudyResults& study);
// One sentence each: whose paper, what of the paper was not reproduced, and what was run.
std::vector<std::string> studied(const inference::StudyResults& study, const Paper& paper);

// Doubts of solvers that claimed an error which the verifier does not confirm, and how often.
inference::Doubts wrong_claims(const inference::StudyResults& study);
// Names each solver that gave no answer in some solves, and why: "FD gave no answer in 60 of 60 solves (crashed): ...".
std::vector<std::string> no_answer_sentences(const inference::StudyResults& study);
std::string limits_sentence(const inference::StudyResults& study);
// Says why times are not ranked; empty if they are.
std::string times_sentence(const inference::StudyResults& study);

}  // namespace ikbench::report
