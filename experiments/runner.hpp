// Runs a study: into a store, only what is missing of it, or without one; every answer verified after the clock
// stopped.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "experiments/shard.hpp"
#include "experiments/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

struct Progress {
  std::int64_t done = 0;  // solves, with those that the store already had
  std::int64_t total = 0;
  std::int64_t reused = 0;              // of those done, how many the store already had
  std::vector<std::string> notes = {};  // at the end: what programs did besides solving, a sentence each
};

struct RunRequest {
  int jobs = 1;                                   // solves at once; times are comparable with 1 only
  std::function<void(const Progress&)> progress;  // called after every solve, by one thread at a time
  std::string command = {};                       // what was typed, for the record
  const std::atomic<bool>* cancelled = nullptr;   // looked at before every solve; what is done stays
  Shard shard = {};                               // what of the study is solved, and counted in the progress
  std::chrono::milliseconds patience{0};          // how long a solve may wait to be stored together with others
};

// `study` is one that the study file's reader would give: known names, as many initial angles as joints.
// The points of a run are chained (the arm starts where the previous answer left it) unless the study starts each at
// its initial configuration; runs are independent. Numbers do not depend on `jobs` (unless a solve ends by its wall
// time), on the order of solvers, or on what the store already had.
// Each solve is timed as often as the study says, its median being its time, if it can be compared: with one job, in no
// debug build, where no solve ends by its wall time. Else it is solved once.
// What is complete is what the store now has under the study's name: else std::invalid_argument, as below.
Progress run(const Study& study, results::Store& store, const RunRequest& request);

// What the store has of the study by another version of the source, of solvers of which it has nothing by this one:
// `run` leaves it where it is, and solves anew.
struct LeftAside {
  std::vector<std::string> labels;
  std::int64_t solves = 0;
};
LeftAside left_aside(const Study& study, const results::Store& store);

// std::invalid_argument where the store's study of that name is another one, or is solved by another version of the
// source: another process saved it meanwhile.
void check_is_stored(const Study& study, const results::Store& store);

// All solves of a study, without a store. `take` gets each as soon as it is done, by one thread at a time: those of a
// run in the order of its points; each is made once, whatever the study says of repeats. `cancelled` is looked at
// before every solve.
void solve_study(const Study& study, int jobs, const std::function<void(results::SolveRecord)>& take,
                 const std::atomic<bool>* cancelled = nullptr);

// One target, by one solver, with every number that a study would record.
results::SolveRecord solve_once(const Study& study, const SolverEntry& entry, const robots::Pose& target);

}  // namespace ikbench::experiments
