// Tables of any study: results, one-way ANOVA of a metric, times and statuses.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"
#include "analysis/statistics/anova.hpp"

namespace ikbench::report {

// Named "results": one row per metric and solver.
Table results_table(const inference::StudyResults& study, std::span<const inference::Metric> metrics);

// Named "further": one row per solver, one column per metric, with the average of its observations.
Table further_table(const inference::StudyResults& study, std::span<const inference::Metric> metrics);

// The ANOVA over all solvers with observations that are all finite; names the others.
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

// Named "solved": number of solves with status ok, with Wilson's interval of the share.
Table solved_table(const inference::StudyResults& study);
// Named "times": median, quantiles and maximum over all solves, and the share over the deadline if there is one.
Table times_table(const inference::StudyResults& study);
// Named "flow": what became of the planned solves of each solver, down to the observations that decide.
Table flow_table(const inference::StudyResults& study);
// Named "status".
Table status_table(const inference::StudyResults& study);

}  // namespace ikbench::report
