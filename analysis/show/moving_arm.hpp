// The data and the library for the moving arm on a report's page. write_report (publish.hpp) calls both functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/judge/data/study_results.hpp"

namespace ikbench::show {

// Returns JSON that is safe inside a script element: the arm, and the targets, starts and answers of each solver's
// first run. At most 200 points of 24 solvers are taken, in the `order` of labels. Returns nullopt if the study's
// definition does not describe the arm, if no solver has a first run, or if a coordinate of a target is beyond 1000 m.
std::optional<std::string> animation_json(const judge::StudyResults& study, const std::vector<std::string>& order);

// Returns the sources of three.js and OrbitControls that the build embedded. Empty if the build had none.
std::string threejs_source();

}  // namespace ikbench::show
