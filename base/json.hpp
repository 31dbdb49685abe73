// Reads and writes JSON text, compiled once here rather than wherever it is used.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace ikbench::base {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;  // members keep their order of insertion

constexpr int deepest_json = 100;  // levels; copies of deeper values would overflow the stack
// Returns a discarded value (is_discarded()) if the text is not JSON or is nested deeper.
Json parsed_json(std::string_view text);
OrderedJson parsed_ordered_json(std::string_view text);

// What results say of a number: null of NaN, and the text Inf or -Inf, since JSON has no such numbers.
OrderedJson json_of(double value);

// Writes one line, or a member a line with `indent` spaces a level. Replaces bytes that are not UTF-8 by U+FFFD. What
// keeps its order is for others, so it is ASCII with escapes.
std::string text_of(const Json& json, int indent = -1);
std::string text_of(const OrderedJson& json, int indent = -1);

}  // namespace ikbench::base
