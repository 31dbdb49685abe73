// Reads and writes JSON text. It is compiled once here, and not wherever it is used, because the library takes seconds
// to compile.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace ikbench::base {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;  // members stay in the order in which they were added

constexpr int max_json_depth = 100;  // levels; a copy of a deeper value could overflow the stack
// Parses a text. Returns a discarded value (is_discarded()) if it is not JSON, or is nested deeper than
// `max_json_depth`.
Json parsed_json(std::string_view text);
OrderedJson parsed_ordered_json(std::string_view text);

// Returns a number as results have it: null for NaN, and the texts Inf and -Inf, since JSON has no such numbers.
OrderedJson json_of(double value);

// Returns the value as one line, or with `indent` spaces per level and one member per line. Bytes that are not UTF-8
// become U+FFFD. Ordered values are for other programs, so their text is ASCII with escapes.
std::string text_of(const Json& json, int indent = -1);
std::string text_of(const OrderedJson& json, int indent = -1);

}  // namespace ikbench::base
