// Runs a study, with or without a store. With a store, only what is missing is solved. Every answer is verified after
// the clock stopped. How times are measured: docs/explanation/methods.md#times.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "experiments/study/study.hpp"
#include "experiments/workers.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// The part of a study to solve, and how.
struct RunRequest {
  int jobs = 1;                                   // solves at once; times are comparable only with 1
  std::function<void(const Progress&)> progress;  // called after every solve, by one thread at a time
  std::string command = {};                       // the typed command, for the record
  const std::atomic<bool>* cancelled = nullptr;   // checked before and after every solve
  Shard shard = {};                               // the part of the study to solve, and to count in the progress
  std::chrono::milliseconds flush_interval{0};    // how long solves may wait for a common transaction
};

// Solves what the store lacks of a study, and returns how many solves there are. `study` has to be as the study reader
// gives it: known names, one initial angle per joint.
// The points of a run are chained (the arm starts where the previous answer left it) unless the study starts each
// elsewhere; runs are independent. Numbers do not depend on `jobs` (unless a solve ends by its wall time), on the order
// of solvers, or on the solves that the store already had.
// Each solve is one timed call, or one of a program's batch. A study is done in turns. Each turn is a session of the
// store, with its share of the runs or targets, processes of its own and another order of the solvers, after a few
// unrecorded solves of each. If solves do not start from the answer before, all solvers solve a target before the next
// one (those with batches last); otherwise a solver makes a run in a row. Within a session all solvers lack the same
// solves, so that their times are of the same targets. A shard is one turn.
// A row is only what the solver did. A solve in which the process stood still for long (PauseWatch) is repeated. A
// solve during which `cancelled` was set is stored only if it succeeded. Names of a class's notes are cut to what the
// store takes.
// Throws std::runtime_error, with the place, for a solve that no reader would take (check_of), such as after a jump of
// the clock; solves before it are stored. Throws std::invalid_argument at the end if another process has saved another
// study of that name.
Progress run(const Study& study, results::Store& store, const RunRequest& request);
// Does the same for a caller who has the to_stored already.
Progress run(const Study& study, const results::StoredStudy& stored, results::Store& store, const RunRequest& request);

// Makes all solves of a study, without a store. `take` receives each as soon as it is done, from one thread at a time,
// within a run in the order of its points. `cancelled` is checked before every solve.
void solve_without_store(const Study& study, int jobs, const std::function<void(results::SolveRecord)>& take,
                         const std::atomic<bool>* cancelled = nullptr);

// Returns true if the next solve of the run begins at this answer. It does not if the answer is no configuration, or if
// every solve has its own start.
bool continues_from(const results::SolveRecord& solve, Start start);

// Solves one target by one solver. The record has every number that a study would have.
results::SolveRecord solve_once(const Study& study, const SolverEntry& entry, const Pose& target);

}  // namespace ikbench::experiments
