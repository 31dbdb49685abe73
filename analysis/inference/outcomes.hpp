// Outcomes: observations that are 0 or 1 each, such as whether a solve succeeded. Their mean is a share, which has
// intervals and tests of its own; tests of means, of normality and of ranks do not apply.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/paired_proportion.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::inference {

// Whether every value is 0 or 1, and both occur. What the quantity is decides, and no test.
bool are_outcomes(const Observations& observations);

// The share of the solves of a solver that have status ok, with Wilson's interval, which is for independent solves,
// such as one a run.
statistics::Proportion solve_rate(const StudyResults& study, std::string_view solver, double level);

statistics::Successes successes_of(const std::vector<double>& values);
statistics::PairedSuccesses paired_successes(const std::vector<double>& first, const std::vector<double>& second);

// Shares with Wilson's intervals in place of means.
void describe_shares(Evidence& evidence, std::span<const std::vector<double>> values);

// What a difference of shares of the margin takes (Contrast::runs_to_decide).
Estimate runs_to_decide_shares(const Evidence& evidence, const Contrast& contrast,
                               std::span<const std::vector<double>> values);

}  // namespace ikbench::inference
