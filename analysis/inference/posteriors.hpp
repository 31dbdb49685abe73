// What the Bayesian signed-rank test says of each pair of groups within blocks, beside what decides.
#pragma once

#include <span>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// Every group's values, on the scale of the evidence. Fills the posteriors of its pairs, with the plan's margin as the
// region of practical equivalence.
void add_posteriors(Evidence& evidence, std::span<const std::vector<double>> values);

}  // namespace ikbench::inference
