// Whether two definitions of a study (JSON, as the store has it) ask for the same solves.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace ikbench::results {

// Parts of a definition on which no solve depends: how it is judged, and which targets were found to be out of reach.
constexpr std::array<std::string_view, 4> decide_no_solve{"analysis", "deadline_ms", "out_of_reach", "repeats"};

// The first field in which they ask for others, with both values: "seed is 1 and 2"; empty where there is none. One
// may ask for more runs.
std::string difference_in_solves(const std::string& definition, const std::string& other);

}  // namespace ikbench::results
