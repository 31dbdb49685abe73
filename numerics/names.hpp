// Names that people type: choices of them, lists of them in messages, and the nearest one to a misspelt name.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ikbench::numerics {

// Names and values, as `choice` of what reads or writes fields takes them.
template <class Enum>
using Choices = std::vector<std::pair<std::string, Enum>>;

// The candidate with the smallest edit distance, or else one that contains the name; empty where none can be meant.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

// `unknown solver "ik_bta"; did you mean "ik_bat"? (there are: ik_bat, bat, ...)`
std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates);

}  // namespace ikbench::numerics
