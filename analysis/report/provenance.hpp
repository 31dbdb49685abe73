// What was run and where, as tables: the definition, every solver's options, the environment of the sessions; and how
// the study stands beside others with the same targets.
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
// The plan that is used, value by value, with those notes; they say too where it is not the study's.
Table plan_table(const results::StudyEntry& entry, const results::AnalysisPlan& used, std::vector<std::string> notes);
// The sessions in which the study's solves were made.
Table environment_table(const inference::StudyResults& study, const std::vector<results::Session>& sessions);
// What was typed to make the last of the study's solves; empty where the store does not say.
std::string command_of(const inference::StudyResults& study, const std::vector<results::Session>& sessions);

// Whether the two studies were given the same targets wherever both have the same run and point.
bool same_targets(const inference::StudyResults& a, const inference::StudyResults& b);
Table baselines_table(const inference::JudgedStudies& studies);

}  // namespace ikbench::report
