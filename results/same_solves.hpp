// Whether two studies of one name ask for the same solves, and what is in both.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "results/store.hpp"

namespace ikbench::results {

// Parts of a definition on which no solve depends: how it is judged, and which targets were found to be out of reach.
constexpr std::array<std::string_view, 4> decide_no_solve{"analysis", "deadline_ms", "out_of_reach", "repeats"};

// Of two definitions (JSON, as the store has them): the first field in which they ask for others, with both values:
// "seed is 1 and 2"; empty where there is none. One may ask for more runs.
std::string difference_in_solves(const std::string& definition, const std::string& other);

// Why two studies of one name cannot be merged; empty where they can: of two numbers of runs the larger is taken.
std::string why_not_one(const StudyEntry& study, const StudyEntry& other);

// The one with more runs, with what was imported into either.
StudyEntry joined(const StudyEntry& study, const StudyEntry& other);

}  // namespace ikbench::results
