// How a study said that it would be judged, and whether it had said so before its solves were made. Stores may be old
// or anybody's: what is missing in them, or is nonsense, is as by default.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "results/analysis_plan.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// As the study's definition has it; a control that is no label of the study is none.
results::AnalysisPlan plan_of(const results::StudyEntry& entry);

struct PlanValue {
  std::string field, text, meaning;
};
std::vector<PlanValue> values_of(results::AnalysisPlan plan);

// How many solves each session made.
using SolvesOfSessions = std::map<std::int64_t, std::int64_t>;

// "significance 0.05 -> 0.01, unit run -> point"; empty where the plans are the same.
std::string changes_between(const results::AnalysisPlan& before, const results::AnalysisPlan& after);

// One for each other plan that solves were made under, as their sessions recorded it: it was changed with their
// numbers known.
Doubts plan_changes(const results::StudyEntry& entry, const std::vector<results::Session>& sessions,
                    const SolvesOfSessions& solves);
// Those, or that nothing was changed; and how many solves have a session that recorded no plan.
std::vector<std::string> plan_notes(const results::StudyEntry& entry, const std::vector<results::Session>& sessions,
                                    const SolvesOfSessions& solves);

}  // namespace ikbench::inference
