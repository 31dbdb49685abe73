// The table of a study for an article: a row for each solver, a column for each quantity that matters most.
#pragma once

#include <functional>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// Named "paper". Its numbers are those that the study is judged by, and its stars are findings. It has so many
// quantities as fit a column of an article: first the share of solves that succeed, errors, time and evaluations.
Table article_table(const inference::JudgedStudy& study);

// The same of several studies that are judged together: their solvers, and the evidence of what all of them judge.
using EvidenceOf = std::function<const inference::Evidence*(inference::Metric, results::Estimand)>;  // null: not judged
Table article_table(const inference::JudgedStudies& studies, const EvidenceOf& evidence_of);

}  // namespace ikbench::report
