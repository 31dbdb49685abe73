// The pairs of groups of an Evidence: how large the difference is, and what each method says of it.
#pragma once

#include <span>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// Of what is there: summaries of every group; values that rank (no NaN), or nothing where only summaries are known.
// Fills contrasts, pairs and reference.
void add_contrasts(Evidence& evidence, std::span<const statistics::GroupSummary> summaries,
                   std::span<const std::vector<double>> values);

// Friedman's test over the blocks, with average ranks (1 is best) and Nemenyi's critical difference.
void add_friedman(Evidence& evidence, std::span<const std::vector<double>> values);

}  // namespace ikbench::inference
