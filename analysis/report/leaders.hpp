// Who is first by each estimand of a metric: the answer of a report, in a line.
#pragma once

#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// "Smallest mean error (large errors dominate): IK-BA (0.0017 cm; next K-ABC 0.208 cm, p = 0.0003)." The first is whom
// the plan's test finds worse than nobody; those that it does not separate from it share its place. With a control: who
// is better than it, and who is not. A cost has beside it how large the errors are. Empty where no solver has a value.
Sentence leader_sentence(const inference::JudgedStudy& study, inference::Metric metric, results::Estimand estimand);
// One for each of estimands_of(study, metric).
std::vector<Sentence> leader_sentences(const inference::JudgedStudy& study, inference::Metric metric);
// What makes all numbers doubtful; who is better by the quantity that the study is judged by
// (primary_estimand); and who leads in each of the others, which are exploratory.
std::vector<Sentence> own_verdict(const inference::JudgedStudy& study);

}  // namespace ikbench::report
