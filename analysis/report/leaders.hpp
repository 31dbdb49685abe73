// Names the leader by each estimand of a metric, in a line: the answer of a report.
#pragma once

#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// "Smallest mean error (large errors dominate): IK-BA (0.0017 cm) is better than K-ABC (0.208 cm): p = 0.0003." The
// short answer of the evidence, with each solver's value; a cost shows the size of the errors too. Empty if no solver
// has a value.
Sentence leader_sentence(const inference::JudgedStudy& study, inference::Metric metric, results::Estimand estimand);
// One sentence per estimand in estimands_of(study, metric).
std::vector<Sentence> leader_sentences(const inference::JudgedStudy& study, inference::Metric metric);
// Sentences on what makes all numbers doubtful, on who is better by the study's primary_estimand, and on who leads by
// each of the others, which are exploratory.
std::vector<Sentence> own_verdict(const inference::JudgedStudy& study);

}  // namespace ikbench::report
