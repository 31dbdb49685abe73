// What a look at more runs than an earlier one had is worth.
#pragma once

#include <vector>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"
#include "results/looks.hpp"

namespace ikbench::inference {

// How many runs of a study are complete for some solver: what a look is at.
int runs_looked_at(const StudyResults& study);

// None where no look was at fewer runs. Look k has the level significance / (k (k - 1)), so that all looks after the
// first together have the level significance (by Bonferroni: the sum over k from 2 is significance).
Doubts look_doubts(const std::vector<results::Look>& looks, int runs, double significance);

}  // namespace ikbench::inference
