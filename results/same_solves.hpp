// Compares two studies of one name: do they ask for the same solves, and what is in both?
#pragma once

#include <string>

#include "results/store.hpp"

namespace ikbench::results {

// The first field in which two definitions (JSON, as the store has them) ask for different solves, with both values:
// "seed is 1 and 2"; empty if there is none. The number of runs may differ.
std::string difference_in_solves(const std::string& definition, const std::string& other);

// Says why two studies of one name cannot be merged; empty if they can. Different numbers of runs can: the larger
// counts.
std::string why_not_one(const StudyEntry& study, const StudyEntry& other);

}  // namespace ikbench::results
