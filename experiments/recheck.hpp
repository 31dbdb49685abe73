// Computes errors, joint motion and status of stored solves again.
#pragma once

#include <functional>

#include "results/store.hpp"

namespace ikbench::experiments {

// A check that computes these of a study's solves again, from arm, target, start and answer of each. It throws
// std::invalid_argument, with the solve's place, where they differ. None for an arm that no arm file
// can be: some from a URDF file.
using SolveCheck = std::function<void(const results::SolveRecord&)>;
SolveCheck recheck_of(const results::StudyEntry& study);

}  // namespace ikbench::experiments
