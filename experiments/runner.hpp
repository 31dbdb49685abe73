// Runs a study, with or without a store; with one, it solves only what is missing. Every answer is verified after the
// clock stopped.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "experiments/study.hpp"
#include "experiments/workers.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

struct RunRequest {
  int jobs = 1;                                   // solves at once; times are comparable with 1 only
  std::function<void(const Progress&)> progress;  // called after every solve, by one thread at a time
  std::string command = {};                       // the typed command, for the record
  const std::atomic<bool>* cancelled = nullptr;   // checked before and after every solve
  Shard shard = {};                               // the part of the study to solve, and to count in the progress
  std::chrono::milliseconds patience{0};          // solves within it of the last transaction wait for the next
};

// `study` must be as the study reader gives it: known names, one initial angle per joint.
// The points of a run are chained (the arm starts where the previous answer left it) unless the study starts each
// elsewhere; runs are independent. Numbers do not depend on `jobs` (unless a solve ends by its wall time), on the order
// of solvers, or on what the store already had.
// The names of a class's notes are cut to what the store takes. A solve that no reader would take (check_of), as after
// a jump of the clock, ends the run with std::runtime_error and its place; those before are stored.
// Each solve is one timed call, or one of a program's batch. A study is done in turns, each a session of the store with
// its share of the runs or targets, processes of its own and another order of the solvers, after a few unrecorded
// solves of each. Where solves do not start from the answer before, all solvers solve a target before the next (those
// with batches behind them); else a solver makes a run in a row. In a session all solvers miss the same, so that their
// times in it are of the same targets; a shard is one turn. A row is only what the solver did: a solve in which the
// process stood still for long (PauseWatch) is made anew, and one in which `cancelled` was set is stored only if it
// solved. Once all is solved, throws std::invalid_argument if another process has saved another study of that name.
Progress run(const Study& study, results::Store& store, const RunRequest& request);
// The same for who has its stored_study.
Progress run(const Study& study, const results::StoredStudy& stored, results::Store& store, const RunRequest& request);

// Makes all solves of a study, without a store. `take` gets each as soon as it is done, by one thread at a time, in a
// run in the order of its points. `cancelled` is checked before every solve.
void solve_study(const Study& study, int jobs, const std::function<void(results::SolveRecord)>& take,
                 const std::atomic<bool>* cancelled = nullptr);

// True if the next solve of the run begins at this one's answer: not where the answer is no configuration, or where
// every solve has its own start.
bool moves_arm(const results::SolveRecord& solve, Start start);

// Solves one target by one solver; the record has every number that a study would have.
results::SolveRecord solve_once(const Study& study, const SolverEntry& entry, const Pose& target);

// A check (recheck.cpp) that computes errors, joint motion and status of a study's solves again, from arm, target,
// start and answer of each. It throws std::invalid_argument, with the solve's place, where they differ, or where no
// solver spends so much; check_of throws it without an arm. `run` stores nothing that it refuses.
results::TakeSolve check_of(const results::StoredStudy& study);
// The same of stored solves, which come by solver, run and point: it also refuses an arm that jumped between two of a
// chain.
results::TakeSolve recheck_of(const results::StoredStudy& study);

// A check that draws targets and starts again from the study's seed, and throws the same where a solve had others; for
// solves that recheck_of took. Null where targets are poses of the study file, which the store has not.
results::TakeSolve redraw_of(const results::StoredStudy& study);

// What solve_again did. A label is left out if its solver is a program or of a library, or of another source.
struct SolvedAgain {
  std::int64_t solves = 0;                                      // made again
  std::int64_t of = 0;                                          // stored ones that could be
  std::vector<std::string> foreign = {}, of_other_source = {};  // labels
};
// Makes solves of the stored study again, at most so many, drawn at random; tells its progress before each. Where the
// clock may end them, none. Throws std::invalid_argument, with the solve's place, where another bit of the answer or
// another count comes.
SolvedAgain solve_again(const results::Store& store, const results::StoredStudy& study, std::int64_t most,
                        const std::function<void(const Progress&)>& progress = {});

}  // namespace ikbench::experiments
