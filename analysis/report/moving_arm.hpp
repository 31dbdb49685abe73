// The arm on its way along the path, for the animated view of the report: what the page has to know, and three.js.
#pragma once

#include <optional>
#include <string>

#include "analysis/inference/study.hpp"
#include "results/store.hpp"

namespace ikbench::report {

// JSON, harmless inside a script element: the arm as the definition has it, the targets, and of every solver the first
// run's starts and answers with the joints that are outside their limits (at most 200 points of 24 solvers). Nothing
// where the definition does not describe the arm or nothing is solved.
std::optional<std::string> moving_arm(const results::StudyEntry& entry, const inference::StudyResults& study);

// three.js and its OrbitControls as they are installed; nothing where they are not.
std::optional<std::string> drawing_library();

}  // namespace ikbench::report
