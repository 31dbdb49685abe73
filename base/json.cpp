#include "base/json.hpp"

#include <cmath>

#include "base/number.hpp"

namespace ikbench::base {

namespace {

// Returns true if lists and objects are nested deeper than `max_json_depth`. The callback of the library would need
// quadratic time.
bool is_too_deep(std::string_view text) {
  int depth = 0;
  bool is_in_string = false;
  for (std::size_t i = 0; i < text.size() && depth <= max_json_depth; ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      is_in_string = !is_in_string;
    else if (!is_in_string)
      depth += (text[i] == '[' || text[i] == '{') - (text[i] == ']' || text[i] == '}');
  }
  return depth > max_json_depth;
}

template <class Value>
Value parsed(std::string_view text) {
  return is_too_deep(text) ? Value(Value::value_t::discarded) : Value::parse(text, nullptr, false);
}

}  // namespace

Json parsed_json(std::string_view text) { return parsed<Json>(text); }

OrderedJson parsed_ordered_json(std::string_view text) { return parsed<OrderedJson>(text); }

OrderedJson json_of(double value) {
  if (std::isfinite(value)) return OrderedJson(value);
  return std::isnan(value) ? OrderedJson() : OrderedJson(text_of(value));
}

std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string text_of(const OrderedJson& json, int indent) {
  return json.dump(indent, ' ', true, OrderedJson::error_handler_t::replace);
}

}  // namespace ikbench::base
