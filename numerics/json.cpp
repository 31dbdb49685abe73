#include "numerics/json.hpp"

namespace ikbench::numerics {

Json parsed_json(std::string_view text) {
  bool is_deep = false;
  const auto is_flat = [&is_deep](int depth, Json::parse_event_t, const Json&) {
    is_deep = is_deep || depth >= deepest_json;  // the outermost value has the depth 0
    return !is_deep;
  };
  Json json = Json::parse(text, is_flat, false);
  return is_deep ? Json(Json::value_t::discarded) : json;
}

OrderedJson parsed_ordered_json(std::string_view text, int deepest) {
  const auto is_flat = [deepest](int depth, OrderedJson::parse_event_t, const OrderedJson&) {
    return depth <= deepest;
  };
  return OrderedJson::parse(text, is_flat, false);
}

std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string text_of(const OrderedJson& json, int indent) {
  return json.dump(indent, ' ', true, OrderedJson::error_handler_t::replace);
}

}  // namespace ikbench::numerics
