// Turns a study into observations: which solves make one observation, which observations share a problem, and notes on
// them.
#pragma once

#include <span>
#include <utility>

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

// The observations that statistics use, by the plan's unit. Runs are in blocks if all solvers share problems:
// - targets drawn in every run, chained: a block is a run, a value its mean;
// - targets drawn in every run, each from its own start: a block is a target, a value its only solve;
// - targets on a path, each from its own start: a block is a target, a value the mean over the runs.
// Else, and for points, each solver is an independent group (samples()), and a note says why there are no blocks.
Observations observations(const StudyResults& study, Metric metric, results::Estimand estimand);
Observations observations(const StudyResults& study, Metric metric);  // by its average (average_estimand)

// Reasons why runs are in no blocks; empty if they are.
Doubts why_not_blocked(const StudyResults& study);

}  // namespace ikbench::inference
