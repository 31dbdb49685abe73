// `key=value` over what a study's table says.
#pragma once

#include <string>

#include "numerics/toml_table.hpp"

namespace ikbench::experiments {

// One override of a study's table; std::invalid_argument names what is wrong with it.
void override_one(toml::table& study, const std::string& text);

}  // namespace ikbench::experiments
