// What it costs to solve a problem of a study, which of two solvers spends less, and who is ahead at set budgets
// (analysis/inference/{cost_comparison,anytime}.hpp).
#pragma once

#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// Where the study has a tolerance "statistics-cost" and of several solvers "statistics-cost-pairs", in evaluations, and
// the same of "statistics-cost-seconds" where times are comparable; "statistics-cost-anytime" where the study has what
// anytime() needs. None without solves.
std::vector<Table> cost_tables(const inference::StudyResults& study);

}  // namespace ikbench::report
