// Text to a TOML table, and `key=value` over what a study's table says.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace ikbench::numerics {

// The `path` of nodes that come from an override; those of a file have none.
constexpr std::string_view override_source = "--set";

// std::invalid_argument says where, as `source`:line:column, and what is wrong.
toml::table parse_toml(std::string_view text, std::string_view source);

// One override of a study's table; std::invalid_argument names what is wrong with it.
void override_one(toml::table& study, const std::string& text);

}  // namespace ikbench::numerics
