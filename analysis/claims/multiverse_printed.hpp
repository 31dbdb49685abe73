// Which universe is the paper's: how many of its printed numbers of error and variation each of them explains.
#pragma once

#include <string>
#include <vector>

#include "analysis/claims/claims_file.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/multiverse.hpp"

namespace ikbench::claims {

// Adds tables and sentences. A printed number is explained where it lies, but for its rounding, in the range that 95 %
// of studies of as many runs would have by that universe. Nothing is added where no
// solver is printed or there are too few runs.
void add_printed(report::MultiverseReport& report, const ClaimsFile& file, const inference::Multiverse& multiverse);

// How many of its printed numbers each solver's first choice explains, by universe, by solver; none where there are too
// few runs. All have the same solvers.
std::vector<std::vector<int>> explained_numbers(const ClaimsFile& file,
                                                const std::vector<inference::Multiverse>& universes);

// A number of universes: "43.2 million", "144".
std::string count_words(double count);

}  // namespace ikbench::claims
