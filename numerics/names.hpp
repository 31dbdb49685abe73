// Names that people type: choices of them, lists of them in messages, the nearest one to a misspelt name, and what a
// message has of one that is long.
#pragma once

#include <cstddef>
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

// The first bytes, at most so many, without the rest of a character of UTF-8 that was cut.
std::string_view front(std::string_view text, std::size_t most);

// `unknown solver "ik_bta"; did you mean "ik_bat"? (there are: ik_bat, bat, ...)`
std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates);

}  // namespace ikbench::numerics
