// Rules for claims about a solver's means against others', of the study's numbers or the printed ones: who is first or
// last, in which order, which compromise is the best, whether they differ at all, and whose runs spread least.
#pragma once

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// The solver's mean is the smallest, or the largest, in each of the claim's metrics.
Claims smallest(const Case& of);
Claims largest(const Case& of);
// The solver and the one that it is compared with are the same within the margin.
Claims alike(const Case& of);
// All solvers in the printed order. Times that are not comparable are not ranked.
Claims ranking(const Case& of);
// The solver dominates the others: better in one of the metrics and worse in none.
Claims compromise(const Case& of);
// The solvers differ by one-way ANOVA, the paper's test, in all judged metrics.
Claims differ(const Case& of);
// The standard deviation over its runs is the smallest, by Brown and Forsythe's test of each pair, after Holm.
Claims least_spread(const Case& of);

}  // namespace ikbench::claims
