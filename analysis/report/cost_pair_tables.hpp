// Which of two solvers spends less until the tolerance, and who is ahead at set budgets (analysis/inference/
// {cost_comparison,anytime}.hpp).
#pragma once

#include <optional>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// "statistics-cost-pairs" or "statistics-cost-seconds-pairs".
Table cost_pair_table(const inference::StudyResults& study, inference::Cost cost, const inference::Clusters& clusters);

// "statistics-cost-anytime".
std::optional<Table> anytime_table(const inference::StudyResults& study, const inference::Clusters& clusters);

}  // namespace ikbench::report
