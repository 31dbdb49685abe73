// Tables of what was run and where: definition, options of each solver, environment of the sessions; and a comparison
// with other studies of the same targets.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/report/table.hpp"
#include "results/store.hpp"

namespace ikbench::report {

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
Table baselines_table(const inference::JudgedStudies& studies);

}  // namespace ikbench::report
