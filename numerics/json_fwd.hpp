// The types of JSON by name alone, for headers: what has JSON values includes numerics/json.hpp, which takes long to
// compile.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace ikbench::numerics {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;  // members keep their order of insertion

}  // namespace ikbench::numerics
