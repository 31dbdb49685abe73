// Turns a study into observations: which solves make one observation, which observations share a problem, and notes on
// them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/observations.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// The problems that all solvers share. In chained solves the start depends on the solver.
enum class Blocks { none, runs, drawn_targets, path_targets };

// Reads the blocks from the study's definition; none if it does not describe its path.
Blocks blocks_of(const StudyResults& study);

using Place = std::pair<int, int>;  // run and point, from 1

// The solve at a place among one solver's solves, in the order of a study; null if there is none.
const Solve* solve_at(std::span<const Solve> solves, const Place& place);

// The places whose solves make one value.
struct Block {
  std::string name;  // "run 2, point 1"
  std::vector<Place> places;
};

// The blocks of the runs that are complete for all solvers; empty for Blocks::none.
std::vector<Block> layout(const StudyResults& study, Blocks blocks);

// The observations that statistics use, by the plan's unit. For runs: blocked_observations() if the study has them,
// else samples(), one group per solver, with a note on why there are no blocks. For points: samples().
Observations observations(const StudyResults& study, Metric metric, results::Estimand estimand);
Observations observations(const StudyResults& study, Metric metric);  // by its average (average_estimand)

// The observations in blocks, if all solvers share problems:
// - targets drawn in every run, chained: a block is a run, a value its mean;
// - targets drawn in every run, each from its own start: a block is a target, a value its only solve;
// - targets on a path, each from its own start: a block is a target, a value the mean over the runs.
// An import that would cost several other solvers runs is left out, and a note says so.
std::optional<Observations> blocked_observations(const StudyResults& study, Metric metric, results::Estimand estimand);

// Reasons why blocked_observations() returns nullopt; empty if it returns some.
Doubts why_not_blocked(const StudyResults& study);

}  // namespace ikbench::inference
