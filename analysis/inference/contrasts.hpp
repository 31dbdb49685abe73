// The pairs of groups of an Evidence: how large the difference is, and what each method says of it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// Of what is there: summaries of every group; values that rank (no NaN), or nothing where only summaries are known.
// Fills contrasts, pairs and reference.
void add_contrasts(Evidence& evidence, std::span<const statistics::GroupSummary> summaries,
                   std::span<const std::vector<double>> values);

// The pairs to compare, first < second in order: all, or those with the reference. Fills pairs and reference.
std::vector<Contrast> shown_pairs(Evidence& evidence);
// By the one rule (judge.hpp), with the p of whichever is ahead.
Relation relation_of(const Evidence& evidence, const Contrast& contrast, double p);

// Whether both groups have one value each, so that Fisher's exact test (within blocks the sign test) judges them.
bool are_constants(const Evidence& evidence, const Contrast& contrast);
// So many observations a group, or blocks, does it take before values can say the same often enough.
int fewest_to_differ(const Evidence& evidence);

// A method that gives every pair a p of its own.
struct PairMethod {
  std::string name;
  std::string note;  // what sets it apart: "pooled variance"
  double Contrast::*p;
};
// Those that were made, in the order in which they are shown.
std::vector<PairMethod> pair_methods(const Evidence& evidence);

// Friedman's test over the blocks, with average ranks (1 is best) and Nemenyi's critical difference.
void add_friedman(Evidence& evidence, std::span<const std::vector<double>> values);

}  // namespace ikbench::inference
