// What ranks say of each pair of groups of an Evidence.
//
// Two groups are compared by their own values alone: whether they differ must not depend on who else takes part
// (Benavoli, Corani and Mangili, JMLR 17 (2016) no. 5). Independent samples differ where two tests find it, so that
// neither small samples nor unequal spreads alone make a difference: Mann and Whitney's, which is exact where both come
// from one distribution, and Brunner and Munzel's, which allows for spreads that differ. Within blocks the sign test
// decides, which is Friedman's of the two: it ranks within each block, so that blocks may have different scales. The
// comparisons of mean ranks over all groups (Dunn; Friedman's, Nemenyi's) stand beside them.
#pragma once

#include <span>
#include <vector>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// Every group's values, the smaller the better, or none where only summaries are known. Fills the p-values of ranks,
// and where ranks decide who is ahead and why a pair has no p. Pairs of the family that are not among `shown` count as
// not found, which is on the safe side.
void add_rank_tests(const Evidence& evidence, std::span<const std::vector<double>> ranked,
                    std::vector<Contrast>& shown);

// The p-values of pairs as planned, for the whole family: a pair that is not shown, or that cannot be tested, counts as
// one that does not differ.
void correct(const Evidence& evidence, double Contrast::*p, std::vector<Contrast>& shown);

}  // namespace ikbench::inference
