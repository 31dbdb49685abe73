// The pairs of groups of an Evidence: how large the difference is, and what each method says of it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/method.hpp"

namespace ikbench::inference {

// Fills contrasts, pairs and reference, and of each contrast what the method that decides and the other numbers say.
void add_contrasts(Evidence& evidence, const Groups& groups);

// By the one rule (judge.hpp), with the p of whichever is ahead.
Relation relation_of(const Evidence& evidence, const Contrast& contrast, double p);

// Whether both groups have one value each, so that Fisher's exact test (within blocks the sign test) judges them.
bool are_constants(const Evidence& evidence, const Contrast& contrast);
// So many observations a group, or blocks, does it take before values can say the same often enough.
int fewest_to_differ(const Evidence& evidence);

}  // namespace ikbench::inference
