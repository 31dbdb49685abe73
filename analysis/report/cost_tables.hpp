// Tables of what a solved problem costs, which of two solvers spends less, and who is ahead at set budgets
// (analysis/inference/costs.hpp).
#pragma once

#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// With a tolerance: "statistics-cost" in evaluations, with several solvers also "statistics-cost-pairs"; the same of
// "statistics-cost-seconds" if times are comparable. With what anytime() needs: "statistics-cost-anytime". Without
// solves there is no table.
std::vector<Table> cost_tables(const inference::StudyResults& study);

}  // namespace ikbench::report
