// Pairs in which some values are not finite: a solver crashed, or its answer is not a number.
#pragma once

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/observations.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::inference {

bool is_finite(const Group& group);  // all of its values are

// Observations with finite values alone; with blocks, those in which every group has one.
Observations of_finite(const Observations& observations);

// Judges two groups. A value that is not finite is worse than any number, but one such run in eight is chance, and says
// nothing of the other seven. So the number of such values and the finite ones are tested separately, each at half the
// level, and what is better in one must not be worse in the other. p is of both together.
Contrast contrast_with_not_finite(const Observations& pair, const results::AnalysisPlan& plan);

}  // namespace ikbench::inference
