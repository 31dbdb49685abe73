// JSON of reports: members keep their order of insertion, and null stands for a number that is not finite.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace ikbench::report {

using Json = nlohmann::ordered_json;

inline Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// Writes JSON for a data block of a page: escapes "<", so that none ends the element.
inline std::string json_in_page(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace ikbench::report
