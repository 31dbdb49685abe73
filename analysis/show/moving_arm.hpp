// Data and three.js for the page's animated view of the arm.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/compare/study.hpp"

namespace ikbench::show {

// JSON, safe inside a script element: the arm, and targets, starts and answers of each solver's first run with the
// joints outside their limits (at most 200 points of 24 solvers, in the given order of labels). nullopt if the
// definition does not describe the arm or nothing is solved.
std::optional<std::string> moving_arm(const compare::StudyResults& study, const std::vector<std::string>& order);

// The installed three.js and its OrbitControls; nullopt if they are not installed.
std::optional<std::string> drawing_library();

}  // namespace ikbench::show
