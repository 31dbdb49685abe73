// The moving arm of a report's page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/judge/data/study_results.hpp"

namespace ikbench::show {

// JSON, safe inside a script element: the arm, and targets, starts and answers of each solver's first run (at most 200
// points of 24 solvers, in the given order of labels). nullopt if the definition does not describe the arm or nothing
// is solved.
std::optional<std::string> animation_json(const judge::StudyResults& study, const std::vector<std::string>& order);

// three.js and its OrbitControls, as they were where the program was built; empty without them.
std::string threejs_source();

}  // namespace ikbench::show
