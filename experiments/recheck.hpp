// Computes errors, joint motion and status of stored solves again.
#pragma once

#include "results/store.hpp"

namespace ikbench::experiments {

// A check that computes these of a study's solves again, from arm, target, start and answer of each, which come by
// solver, run and point. It throws std::invalid_argument, with the solve's place, where they differ, or where an arm
// jumped between two solves of a chain; recheck_of throws it if there is no arm.
results::TakeSolve recheck_of(const results::StudyEntry& study);

}  // namespace ikbench::experiments
