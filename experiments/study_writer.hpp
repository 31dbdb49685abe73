// Writes a study as text: TOML to edit and run, JSON for the store.
#pragma once

#include <string>

#include "experiments/study.hpp"

namespace ikbench::experiments {

// The whole study; parse_study gives the same study back.
std::string to_toml(const Study& study);
// A path, as in the study's table [path].
std::string to_toml(Path path);
// The study without its solvers, with its number of points and its arm, as the store keeps it.
std::string to_json(const Study& study);
// The arm's links, base and tool, as in its file.
std::string to_json(const robots::Robot& arm);
// A plan, as in the definition at "/analysis".
std::string to_json(const results::Plan& plan);

}  // namespace ikbench::experiments
