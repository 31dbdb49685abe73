// Detects that the machine ran at two speeds while it solved a study.
#pragma once

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// Two speeds show in every solver as two groups of seconds per evaluation with almost nothing between. Takes clean
// times of solves with at least half the usual evaluations; in shorter ones overhead counts too much. Empty with fewer
// than two such solvers.
Doubts speed_doubts(const StudyResults& study);

}  // namespace ikbench::inference
