// A study as text: TOML to be edited and run, JSON for the store.
#pragma once

#include <string>

#include "experiments/study.hpp"

namespace ikbench::experiments {

// The whole study, to be edited and run; parse_study gives the same study back.
std::string to_toml(const Study& study);
// A path as it stands there, at [path].
std::string to_toml(Path path);
// The whole study without its solvers and with its number of points and its arm, as the store keeps it.
std::string to_json(const Study& study);
// A plan as it stands there, at "/analysis".
std::string to_json(const results::AnalysisPlan& plan);

}  // namespace ikbench::experiments
