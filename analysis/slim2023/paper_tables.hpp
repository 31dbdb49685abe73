// The tables of Slim et al. (2023) for any study, each number beside the printed one if the study is like the paper's:
// Table 3 (what was reached), Tables 4 to 6 (one-way ANOVA of error, variation and time), Table 7 (times to the
// tolerance at random targets) and Table 8 (joint angles on a circle).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/claims/printed.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::slim2023 {

// The paper's metrics, and the numbers of their printed pieces: the table of the ANOVA, the figures of curves over the
// points and of box plots.
struct PaperMetric {
  inference::Metric metric;
  int anova_table, curves_figure, box_figure;
};
constexpr std::array<PaperMetric, 3> paper_metrics{{{inference::Metric::position_error_cm, 4, 6, 10},
                                                    {inference::Metric::variation_deg, 5, 7, 11},
                                                    {inference::Metric::seconds, 6, 8, 12}}};
constexpr std::string_view own_solver = "IK-BA";

// The rows of the printed Table 3 for one metric, if the study is on its path. A circle is Table 8's, random targets
// are Table 7's, whatever the labels of the solvers.
std::vector<claims::PrintedRow> printed_table_3(const inference::StudyResults& study, inference::Metric metric);
// One solver's row.
std::optional<claims::PrintedRow> printed_row(const inference::StudyResults& study, std::string_view solver,
                                              inference::Metric metric);

report::Table table_3(const inference::StudyResults& study);
std::optional<report::Table> table_7(const inference::StudyResults& study);
std::optional<report::Table> table_8(const inference::StudyResults& study);

// The paper's two readings of what is searched, side by side: the study's own (Sec. 4.3), and that of the companion
// with all joints (Sec. 5.1).
struct Readings {
  const inference::JudgedStudy &wrist, &all_joints;
};
// The means of error and variation by both, beside the printed ones.
report::Table means_by_reading(const Readings& readings);
// The claims that need neither times nor another study, judged by both.
report::Table claims_by_reading(const Readings& readings, const decltype(report::Paper::claims)& claims_of);

// All of them that the study has, in the paper's order.
std::vector<report::Table> paper_tables(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
