// Outcomes: observations that are 0 or 1 each, such as whether a solve succeeded. Their mean is a share, which has
// intervals and tests of its own; tests of means, of normality and of ranks do not apply.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::inference {

constexpr std::string_view cochran_name = "Cochran's Q test";

// Whether every value is 0 or 1, and both occur. What the quantity is decides, and no test.
bool are_outcomes(const Observations& observations);

// The share of the solves of a solver that have status ok, with Wilson's interval, which is for independent solves,
// such as one a run.
statistics::Proportion solve_rate(const StudyResults& study, std::string_view solver, double level);

// Shares with Wilson's intervals; each pair by Fisher's exact test or, within blocks, McNemar's, corrected as planned,
// with Newcombe's interval of the difference, which holds for the whole family by Bonferroni; within blocks, Cochran's
// Q of all groups. The margin counts as a difference of shares: 5 percentage points.
void compare_outcomes(Evidence& evidence, std::span<const std::vector<double>> values);

}  // namespace ikbench::inference
