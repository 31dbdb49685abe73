// Data and three.js for the report's animated view of the arm on its path.
#pragma once

#include <optional>
#include <string>

#include "analysis/inference/study.hpp"
#include "results/store.hpp"

namespace ikbench::report {

// JSON, safe inside a script element: the arm's definition, the targets, and the starts and answers of each solver's
// first run with the joints outside their limits (at most 200 points of 24 solvers). nullopt if the definition does not
// describe the arm or nothing is solved.
std::optional<std::string> moving_arm(const results::StudyEntry& entry, const inference::StudyResults& study);

// The installed three.js and its OrbitControls; nullopt if they are not installed.
std::optional<std::string> drawing_library();

}  // namespace ikbench::report
