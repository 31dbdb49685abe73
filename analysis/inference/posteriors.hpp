// What the Bayesian signed-rank test says of each pair of groups within blocks, beside what decides.
#pragma once

#include <span>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// Every group's values, the smaller the better. Fills the posteriors of the pairs, with the plan's margin as the region
// of practical equivalence.
void add_posteriors(const Evidence& evidence, std::span<const std::vector<double>> ranked,
                    std::vector<Contrast>& shown);

}  // namespace ikbench::inference
