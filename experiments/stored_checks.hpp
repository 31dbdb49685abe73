// Checks of stored solves: whether the numbers of a solve follow from its answer, whether its target and start follow
// from the seed of the study, and whether the solver gives the same answer again. `run` uses the first before it stores
// a solve; `ikbench verify` uses all three, and `merge` and reports use the first. What each check can find:
// docs/explanation/methods.md.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "experiments/study/study.hpp"
#include "experiments/workers.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Returns a stored study without its solvers and path. Throws std::invalid_argument if the stored arm cannot be read.
Study study_in_store(const results::StoredStudy& stored);
// Returns the target of a solve. Throws std::invalid_argument if the record has none.
Pose target_of(const results::SolveRecord& solve);

// Returns a check of a study's solves. The check computes errors, joint motion and status of each solve again, from
// arm, target, start and answer. It throws std::invalid_argument, with the place of the solve, if they differ, or if no
// solver of the study can have used so much. `run` stores nothing that the check refuses. Throws std::invalid_argument
// if the study has no arm.
results::SolveVisitor answer_check(const results::StoredStudy& study);
// Returns answer_check for stored solves, which must come by solver, run and point. The check also refuses an arm that
// jumped between two solves of a chain.
results::SolveVisitor stored_solve_check(const results::StoredStudy& study);

// Returns a check that draws targets and starts again from the study's seed. The check throws std::invalid_argument,
// with the place of the solve, if the solve had others. It is for solves that stored_solve_check accepted. Null if the
// targets are poses of a file, which the store does not have.
results::SolveVisitor target_replay_check(const results::StoredStudy& stored);

// The result of rerun_sample. A label is in neither list if its solves can be repeated.
struct RerunReport {
  std::int64_t solves = 0;                       // solves that were repeated
  std::int64_t eligible = 0;                     // stored solves that could be repeated
  std::vector<std::string> external = {};        // labels of programs and of solvers of libraries
  std::vector<std::string> changed_source = {};  // labels of solvers that were another version
  // Labels of answers made elsewhere whose file in the current folder was changed since they were solved.
  std::vector<std::string> changed_answers = {};
};
// Repeats solves of the stored study, at most `max_solves`, chosen at random, and calls `progress` before each. It
// repeats none if the clock may end solves. Throws std::invalid_argument, with the place of the solve, if a bit of the
// answer or a count differs.
RerunReport rerun_sample(const results::Store& store, const results::StoredStudy& stored, std::int64_t max_solves,
                         const std::function<void(const Progress&)>& progress = {});

}  // namespace ikbench::experiments
