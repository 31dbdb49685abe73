// Rules for claims about a solver's means against others', of the study's numbers or the printed ones: who is first or
// last, in which order, which compromise is the best, whether they differ at all, and whose runs spread least.
#pragma once

#include <vector>

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// The solver's mean is the smallest, or the largest, in each of the claim's metrics.
std::vector<report::Claim> smallest(const Case& of);
std::vector<report::Claim> largest(const Case& of);
// All solvers in the printed order. Times that are not comparable are not ranked.
std::vector<report::Claim> ranking(const Case& of);
// The solver dominates the others: better in one of the metrics and worse in none.
std::vector<report::Claim> compromise(const Case& of);
// The solvers differ by one-way ANOVA, the paper's test, in all judged metrics.
std::vector<report::Claim> differ(const Case& of);
// The standard deviation over its runs is the smallest, by Brown and Forsythe's test of each pair, after Holm.
std::vector<report::Claim> least_spread(const Case& of);
// Second differences of the angles along the path, and the largest move of a joint, are the smallest.
std::vector<report::Claim> smoothest(const Case& of);

}  // namespace ikbench::claims
