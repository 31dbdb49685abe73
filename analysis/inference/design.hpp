// What of a study are observations: which solves make one, which of them were given the same problem, and what a reader
// must know of them.
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

// What all solvers are given alike; where solves are chained, where one starts is the solver's own doing.
enum class Blocks { none, runs, drawn_targets, path_targets };

// As the study's definition has it: none where it does not say what its path is.
Blocks blocks_of(const StudyResults& study);

using Place = std::pair<int, int>;  // run and point, from 1

// Of solves of one solver, in the order of a study; null where they have none there.
const Solve* solve_at(std::span<const Solve> solves, const Place& place);

// The solves that make one value.
struct Block {
  std::string name;  // "run 2, point 1"
  std::vector<Place> places;
};

// Of the runs that all solvers of the study have complete; none for Blocks::none.
std::vector<Block> layout(const StudyResults& study, Blocks blocks);

// What the statistics are made of, by the unit of the plan: of runs, blocked_observations() where there are some; else
// the values of samples(), a group for every solver, of runs with a note that says why there are no blocks.
Observations observations(const StudyResults& study, Metric metric, results::Estimand estimand);
Observations observations(const StudyResults& study, Metric metric);  // by its average (average_estimand)

// The design in which all solvers are given the same problems, where the study has one:
// - targets drawn in every run, and chained: a block is a run, a value its mean;
// - targets drawn in every run, each from the initial configuration: a block is a target, a value its only solve;
// - a path, each of its targets from the initial configuration: a block is a target, a value the mean over the runs.
// An import that would take runs from several other solvers is left out, and a note says so.
std::optional<Observations> blocked_observations(const StudyResults& study, Metric metric, results::Estimand estimand);

// Why there is none; empty where there is one.
Doubts why_not_blocked(const StudyResults& study);

}  // namespace ikbench::inference
