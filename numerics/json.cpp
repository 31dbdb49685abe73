#include "numerics/json.hpp"

namespace ikbench::numerics {

namespace {

// Whether lists and objects are nested deeper. The library's callback tells it in quadratic time.
bool is_deeper(std::string_view text, int deepest) {
  int depth = 0;
  bool is_in_string = false;
  for (std::size_t i = 0; i < text.size() && depth <= deepest; ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      is_in_string = !is_in_string;
    else if (!is_in_string)
      depth += (text[i] == '[' || text[i] == '{') - (text[i] == ']' || text[i] == '}');
  }
  return depth > deepest;
}

template <class Value>
Value parsed(std::string_view text, int deepest) {
  return is_deeper(text, deepest) ? Value(Value::value_t::discarded) : Value::parse(text, nullptr, false);
}

}  // namespace

Json parsed_json(std::string_view text) { return parsed<Json>(text, deepest_json); }

OrderedJson parsed_ordered_json(std::string_view text, int deepest) { return parsed<OrderedJson>(text, deepest); }

std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string text_of(const OrderedJson& json, int indent) {
  return json.dump(indent, ' ', true, OrderedJson::error_handler_t::replace);
}

}  // namespace ikbench::numerics
