// Overrides of a study's table: `key=value`.
#pragma once

#include <string>

#include "numerics/toml_table.hpp"

namespace ikbench::experiments {

// Applies one override to a study's table; std::invalid_argument says what is wrong with it.
void override_one(toml::table& study, const std::string& text);

}  // namespace ikbench::experiments
