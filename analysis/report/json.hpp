// JSON as reports write it: members in the order in which they are put in, and null for what is not a finite number.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace ikbench::report {

using Json = nlohmann::ordered_json;

inline Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace ikbench::report
