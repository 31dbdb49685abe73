// What of a study are observations: which solves make one, which of them were given the same problem, and what a reader
// must know of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/observations.hpp"
#include "analysis/study.hpp"

namespace ikbench {

constexpr std::string_view points_flaw =
    "points of one run depend on each other; used as observations because --force was given";

// What the statistics are made of: of runs, blocked_observations() where there are some; else the values of samples(),
// a group for every solver, of runs with a note that says why there are no blocks.
Observations observations(const StudyResults& study, Metric metric, Unit unit);

// The design in which all solvers are given the same problems, where the study has one:
// - targets drawn in every run, and chained: a block is a run, a value its mean;
// - targets drawn in every run, each from the initial configuration: a block is a target, a value its only solve;
// - a path, each of its targets from the initial configuration: a block is a target, a value the mean over the runs.
std::optional<Observations> blocked_observations(const StudyResults& study, Metric metric);

// Why there is none, in a sentence; empty where there is one.
std::string why_not_blocked(const StudyResults& study);

}  // namespace ikbench
