// Overrides of a study's table: `key=value`.
#pragma once

#include <string>

#include "numerics/toml_table.hpp"

namespace ikbench::experiments {

// Applies one override to a study's table; std::invalid_argument says what is wrong with it.
void override_one(toml::table& study, const std::string& text);

// The override that sweeps a setting: "population=10,20" becomes "sweep.population=[10, 20]".
// std::invalid_argument says what is wrong with it.
std::string sweep_override(const std::string& text);

}  // namespace ikbench::experiments
