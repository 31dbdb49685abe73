// The pairs of groups of an Evidence: size of the difference and result of each method.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/method.hpp"

namespace ikbench::inference {

// Fills contrasts, pairs and reference of the evidence.
void add_contrasts(Evidence& evidence, const Groups& groups);

// The verdict by judge.hpp's rule, where p is for the group that is ahead.
Relation relation_of(const Evidence& evidence, const Finding& contrast, double p);

// Returns whether each group has one value only, so that Fisher's exact test (within blocks the sign test) judges them.
bool are_constants(const Evidence& evidence, const Finding& contrast);
// Returns whether a group is a value that is known without chance (`copies`).
bool has_known(const Evidence& evidence, const Finding& contrast);
// Fewest observations per group (or blocks) at which the test can find a difference at all.
int fewest_to_differ(const Evidence& evidence);

}  // namespace ikbench::inference
