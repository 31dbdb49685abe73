// Runs a study, with or without a store. With a store, only missing solves are made. Every answer is verified after the
// clock has stopped. `ikbench run` and programs that use the libraries begin here. How times are measured:
// docs/explanation/methods.md#times.
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
  std::string command = {};                       // the typed command, which the session keeps
  const std::atomic<bool>* cancelled = nullptr;   // checked before and after every solve
  Shard shard = {};                               // the part of the study to solve, and to count in the progress
  std::chrono::milliseconds flush_interval{0};    // how long solves may wait for a common transaction
};

// Makes the solves of a study that the store lacks, and returns how many solves there are. `study` must be as the
// reader of studies gives it: known names, one initial value per joint.
//
// Runs are independent. Within a run each solve starts at the previous answer, unless the study starts it elsewhere.
// Numbers do not depend on `jobs` (unless a solve ends by its wall time), on the order of the solvers, or on the solves
// that the store already had.
//
// Each solve is one timed call, or one of a program's batch. A study is done in rounds. Each round is a session of the
// store, with a share of the runs or targets, new processes and another order of the solvers, after a few unrecorded
// solves of each solver. If solves do not start at the previous answer, all solvers solve a target before the next one
// (those with batches last); otherwise a solver makes a run in a row. Within a session all solvers lack the same
// solves, so that their times are of the same targets. A shard is one round.
//
// A solve during which the process was suspended for long (SuspensionWatch) is repeated. A solve during which
// `cancelled` was set is stored only if it succeeded. Names of a class's extras are cut to what the store takes.
//
// Throws std::runtime_error, with the place, for a solve that no reader would take (answer_check), such as after a jump
// of the clock; solves before it are stored. Throws std::invalid_argument at the end if another process has saved
// another study of that name.
Progress run(const Study& study, results::Store& store, const RunRequest& request);
// Does the same with `stored`, which is to_stored(study), for a caller who has it already.
Progress run(const Study& study, const results::StoredStudy& stored, results::Store& store, const RunRequest& request);

// Makes all solves of a study, without a store. `take` receives each record as soon as it is made, from one thread at a
// time, within a run in the order of the points. `cancelled` is checked before every solve.
void solve_without_store(const Study& study, int jobs, const std::function<void(results::SolveRecord)>& take,
                         const std::atomic<bool>* cancelled = nullptr);

// Returns true if the next solve of the run starts at this answer. Returns false if the answer is not finite, or if
// every solve has its own start.
bool continues_from(const results::SolveRecord& solve, Start start);

// Solves one target by one solver, without a store. The record has every number that a study would have.
results::SolveRecord solve_once(const Study& study, const SolverEntry& entry, const Pose& target);

}  // namespace ikbench::experiments
