#include "numerics/json.hpp"

namespace ikbench::numerics {

Json parsed_json(std::string_view text) { return Json::parse(text, nullptr, false); }

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
  return json.dump(indent, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace ikbench::numerics
