// The one door from solves to numbers that are compared: what is odd becomes a doubt here, and what passes is finite.
#pragma once

#include <span>
#include <vector>

#include "analysis/compare/doubt.hpp"
#include "analysis/compare/metrics.hpp"
#include "analysis/compare/study.hpp"

namespace ikbench::compare {

bool gave_answer(const Solve& solve);
// All solves are the same, bit for bit, and took as many evaluations.
bool have_same_solves(std::span<const Solve> solves, std::span<const Solve> others);

// Of all that concerns more than one metric.
std::vector<Doubt> doubts_of(const StudyResults& study);

// One observation is the mean of a run over its targets where solves are chained (of times the median); else a target,
// its mean over the runs.
Observations observe(const StudyResults& study, const Metric& metric);

}  // namespace ikbench::compare
