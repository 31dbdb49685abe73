// Compares universes with the paper: the number of printed numbers of error and variation that each explains.
#pragma once

#include <string>
#include <vector>

#include "analysis/claims/claims_file.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/multiverse.hpp"

namespace ikbench::claims {

// Adds tables and sentences. A universe explains a printed number if, up to its rounding, it lies in the range of 95 %
// of studies with as many runs. Adds nothing if no solver is printed or there are too few runs.
void add_printed(report::MultiverseReport& report, const ClaimsFile& file, const inference::Multiverse& multiverse);

// The number of printed numbers that each solver's first choice explains, by universe, by solver; empty if there are
// too few runs. All universes need the same solvers.
std::vector<std::vector<int>> explained_numbers(const ClaimsFile& file,
                                                const std::vector<inference::Multiverse>& universes);

// A number of universes: "43.2 million", "144".
std::string count_words(double count);

}  // namespace ikbench::claims
