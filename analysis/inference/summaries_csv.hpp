// Reads published means and standard deviations from a user's CSV. Every mistake in a file throws
// std::invalid_argument: one sentence with the file, the row and what was expected.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/inference/observations.hpp"

namespace ikbench::inference {

// Columns, in any case: name (or group, solver, algorithm), mean, sd (or std, stddev), n (or count); and for several
// quantities metric (or quantity, variable). Returns one Summaries per quantity, in the order of first rows.
std::vector<Summaries> read_summaries(std::string_view text, std::string_view source);

}  // namespace ikbench::inference
