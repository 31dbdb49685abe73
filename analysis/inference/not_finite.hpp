// Judges pairs in which some values are not finite: a solver crashed, or its answer is not a number.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/observations.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::inference {

// Number of values that are not finite.
std::size_t count_not_finite(const Group& group);

// A note for each group that has such values.
std::vector<std::string> notes_of_not_finite(const std::vector<Group>& groups);

// Keeps finite values only; with blocks, the blocks in which every group has one.
Observations of_finite(const Observations& observations);

// Judges two groups. A value that is not finite is worse than any number, but one such run in eight may be chance, and
// says nothing of the other seven. So the number of such values and the finite ones are tested separately, each at half
// the level, and the better group in one must not be worse in the other. p covers both tests.
Finding contrast_with_not_finite(const Observations& pair, const results::AnalysisPlan& plan);

}  // namespace ikbench::inference
