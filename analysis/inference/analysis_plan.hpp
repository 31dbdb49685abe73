// Reads a study's analysis plan, and tells whether the plan was fixed before the solves were made. A missing field
// takes its default; a damaged plan throws std::invalid_argument.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"
#include "results/analysis_plan.hpp"
#include "results/figure_style.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// Returns the plan in the study's definition. Ignores a control that is no label of the study.
results::AnalysisPlan plan_of(const results::StudyEntry& entry);

// Returns the look of figures in the study's definition. Throws std::invalid_argument if it has a value that no study
// file may have.
results::FigureStyle figure_style_of(const results::StudyEntry& entry);

// The field, its value as text, and its meaning.
std::vector<std::array<std::string, 3>> values_of(results::AnalysisPlan plan);

// Lists the changes: "significance 0.05 -> 0.01, unit run -> point"; empty if the plans are the same.
std::string changes_between(const results::AnalysisPlan& before, const results::AnalysisPlan& after);

// Returns one doubt per other plan that sessions recorded for their solves: the plan was changed after numbers were
// known.
Doubts plan_changes(const results::StudyEntry& entry, const std::vector<results::Session>& sessions,
                    const SolvesOfSessions& solves);
// Words plan_changes(), or says that nothing was changed.
std::vector<std::string> plan_notes(const results::StudyEntry& entry, const std::vector<results::Session>& sessions,
                                    const SolvesOfSessions& solves);

}  // namespace ikbench::inference
