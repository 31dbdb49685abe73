// Outcomes: observations that are 0 or 1 each, such as whether a solve succeeded. Their mean is a share, which has
// intervals and tests of its own; tests of means and of ranks do not apply.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::inference {

// Returns whether every value is 0 or 1, and no logarithm. If they are not known to be shares, both must occur.
bool are_outcomes(const Observations& observations);

// Share of a solver's solves with status ok, with Wilson's interval. The interval assumes independent solves, such as
// one per run.
Estimate solve_rate(const StudyResults& study, std::string_view solver, double level);

statistics::Successes successes_of(const std::vector<double>& values);
statistics::PairedSuccesses paired_successes(const std::vector<double>& first, const std::vector<double>& second);

// "20 runs can miss what happens in up to 14 % of them", such as a failure
std::string rare_failures_words(int observations, std::string_view of_what, double significance);

}  // namespace ikbench::inference
