// What it costs to come to the tolerance of a study: how many solves do, expected running time, survival curves and
// their log-rank test (methods and sources: analysis/statistics/{proportion,running_time,survival,log_rank}.hpp).
#pragma once

#include <optional>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"
#include "analysis/statistics/running_time.hpp"

namespace ikbench::report {

// "statistics-cost", in evaluations, and "statistics-cost-seconds" where times are comparable. None where the study has
// no tolerance or no solves.
std::vector<Table> cost_tables(const inference::StudyResults& study);

}  // namespace ikbench::report
