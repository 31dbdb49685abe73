// Who is first by each estimand of a metric: the answer of a report, in a line.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"

namespace ikbench::report {

// "Smallest mean error (large errors dominate): IK-BA (0.0017 cm; next K-ABC 0.208 cm, p = 0.0003)." Those that
// the plan's test does not separate from the first share its place. Empty where no solver has a value.
std::string leader_sentence(const inference::JudgedStudy& study, inference::Metric metric, results::Estimand estimand);
// One for each of estimands_of(study, metric).
std::string leaders_sentence(const inference::JudgedStudy& study, inference::Metric metric);
// Who is better, by how much, and at what cost: in how many comparisons a solver is better than every other, then a
// sentence for each.
std::vector<std::string> own_verdict(const inference::JudgedStudy& study);

}  // namespace ikbench::report
