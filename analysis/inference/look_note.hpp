// Corrects significance when a study is judged again with more runs.
#pragma once

#include <vector>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"
#include "results/looks.hpp"

namespace ikbench::inference {

// Number of runs that are complete for at least one solver: the size of a look.
int runs_looked_at(const StudyResults& study);

// Empty if no earlier look had fewer runs. Look k has the level significance / (k (k - 1)): over all k from 2 these sum
// to significance, so all looks after the first together keep it (Bonferroni).
Doubts look_doubts(const std::vector<results::Look>& looks, int runs, double significance);

}  // namespace ikbench::inference
