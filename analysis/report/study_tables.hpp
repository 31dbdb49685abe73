// Tables of any study: results, one-way ANOVA of a metric, times and statuses; and of studies with the same targets.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/report/table.hpp"
#include "analysis/statistics/anova.hpp"
#include "results/store.hpp"

namespace ikbench::report {

// Named "results": one row per metric and solver.
Table results_table(const inference::StudyResults& study, std::span<const inference::Metric> metrics);

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
// Named "status": what became of the planned solves of each solver, down to the observations that decide.
Table status_table(const inference::StudyResults& study);

// Named "baselines": the averages of other studies with the same targets.
Table baselines_table(const inference::JudgedStudies& studies);
// Named "limits": what remains of a study's findings if joint limits are enforced. `studies` have the same targets, the
// reported one first. Pairs it with the first other study that shares a solver and treats limits the other way
// (enforced or not). nullopt if there is none.
std::optional<Table> limits_table(const inference::JudgedStudies& studies);

// Tables of what was run and where.
Table definition_table(const results::StudyEntry& entry);
Table options_table(const results::StudyEntry& entry);
// The plan in use, value by value, with `notes`. A note says so if it is not the study's own.
Table plan_table(const results::StudyEntry& entry, const results::AnalysisPlan& used, std::vector<std::string> notes);
// The sessions in which the study's solves were made.
Table environment_table(const inference::StudyResults& study, const std::vector<results::Session>& sessions);
// The command line that made the study's last solves; empty if the store lacks it.
std::string command_of(const inference::StudyResults& study, const std::vector<results::Session>& sessions);

// Returns whether two studies have the same targets at every run and point that both have.
bool same_targets(const inference::StudyResults& a, const inference::StudyResults& b);

}  // namespace ikbench::report
