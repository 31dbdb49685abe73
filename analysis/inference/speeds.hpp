// Whether the machine went at two speeds while it solved a study.
#pragma once

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// Two speeds show as two groups of seconds per evaluation in every solver, with next to nothing between them. Looked at
// are clean times of solves with at least half as many evaluations as is usual: of fewer, more of the time is no
// evaluation. None where there are fewer than two solvers to look at.
Doubts speed_doubts(const StudyResults& study);

}  // namespace ikbench::inference
