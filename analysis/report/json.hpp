// JSON of reports: members keep their order of insertion, and null stands for a number that is not finite.
#pragma once

#include <cmath>
#include <string>

#include "analysis/report/table.hpp"
#include "numerics/json.hpp"

namespace ikbench::report {

using Json = numerics::OrderedJson;

inline Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// The rows of a table as an array of objects, with the names of its columns. An interval has low and high, and a number
// beside a printed one has ours and printed.
Json rows_json(const Table& table);

// Writes JSON for a data block of a page: escapes "<", so that none ends the element.
inline std::string json_in_page(const Json& json) {
  std::string text = numerics::text_of(json);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace ikbench::report
