// What it costs to come to the tolerance of a study: how many solves do, expected running time, survival curves and
// their log-rank test (methods and sources: analysis/statistics/{proportion,running_time,survival}.hpp).
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
