// The tables of any study: what was reached, the one-way ANOVA of a metric, and the status of every solve.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"
#include "analysis/statistics/anova.hpp"

namespace ikbench::report {

// Named "results": a row a metric and solver.
Table results_table(const inference::StudyResults& study, std::span<const inference::Metric> metrics);

// Named "further": a row a solver, a column a metric, with the average of its observations.
Table further_table(const inference::StudyResults& study, std::span<const inference::Metric> metrics);

// The ANOVA over all solvers that have observations and only finite ones; the others are named.
struct StudyAnova {
  statistics::AnovaTable table;
  std::vector<std::string> left_out;  // a sentence each
};
StudyAnova anova(const inference::StudyResults& study, inference::Metric metric);

// "anova-error", "anova-variation", ...
Table anova_table(const inference::StudyResults& study, inference::Metric metric);
// Its rows between, within and total, each with the cells SS, df, MS, F and p.
constexpr std::array<std::string_view, 3> anova_sources{"between", "within", "total"};
std::array<std::vector<Cell>, 3> anova_cells(const statistics::AnovaTable& table);

// Named "solved": how many solves have the status ok, with Wilson's interval of the solver's chance.
Table solved_table(const inference::StudyResults& study);
// Named "times", of all solves: median, quantiles, the longest, and the share over the deadline where there is one.
Table times_table(const inference::StudyResults& study);
// Named "status".
Table status_table(const inference::StudyResults& study);

}  // namespace ikbench::report
