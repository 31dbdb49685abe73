// Reads a study's analysis plan, and tells whether the plan was fixed before the solves were made. Stores may be old or
// foreign: a missing or invalid field takes its default.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "results/analysis_plan.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// Returns the plan in the study's definition. Ignores a control that is no label of the study.
results::AnalysisPlan plan_of(const results::StudyEntry& entry);

struct PlanValue {
  std::string field, text, meaning;
};
std::vector<PlanValue> values_of(results::AnalysisPlan plan);

// Number of solves by session id.
using SolvesOfSessions = std::map<std::int64_t, std::int64_t>;

// Lists the changes: "significance 0.05 -> 0.01, unit run -> point"; empty if the plans are the same.
std::string changes_between(const results::AnalysisPlan& before, const results::AnalysisPlan& after);

// Returns one doubt per other plan that sessions recorded for their solves: the plan was changed after numbers were
// known.
Doubts plan_changes(const results::StudyEntry& entry, const std::vector<results::Session>& sessions,
                    const SolvesOfSessions& solves);
// Words plan_changes(), or says that nothing was changed; and counts the solves whose session recorded no plan.
std::vector<std::string> plan_notes(const results::StudyEntry& entry, const std::vector<results::Session>& sessions,
                                    const SolvesOfSessions& solves);

}  // namespace ikbench::inference
