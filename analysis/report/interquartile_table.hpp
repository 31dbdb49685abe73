// The interquartile mean of a metric over all solves (analysis/statistics/interquartile_mean.hpp).
#pragma once

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// "statistics-NAME-interquartile": a row a solver, of its complete runs. Where all solvers start each target of a path
// from the same configuration, runs are drawn anew for each target; else whole runs are, because the solves of a run
// depend on each other or have targets of their own.
Table interquartile_table(const inference::StudyResults& study, inference::Metric metric);

}  // namespace ikbench::report
