// Checks of stored solves: whether the numbers of a solve follow from its answer, whether its target and start follow
// from the seed of the study, and whether the solver gives the same answer again. `run` uses the first before it stores
// a solve; readers of a store use all three (ikbench verify).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "experiments/workers.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Returns a check of a study's solves. It computes errors, joint motion and status of each again, from
// arm, target, start and answer. The check throws std::invalid_argument, with the place of the solve, if they differ,
// or if no solver spends so much. check_of itself throws it if the study has no arm. `run` stores nothing that the
// check refuses.
results::SolveVisitor answer_check(const results::StoredStudy& study);
// Returns the same check for stored solves, which have to come by solver, run and point. It also refuses an arm that
// jumped between two solves of a chain.
results::SolveVisitor stored_solve_check(const results::StoredStudy& study);

// Returns a check that draws targets and starts again from the study's seed, and throws the same if a solve had others.
// It is for solves that recheck_of accepted. Null if targets are poses of the study file, which the store does not
// have.
results::SolveVisitor target_replay_check(const results::StoredStudy& study);

// The result of solve_again. A label is left out if its solver is a program, of a library, or of another source.
struct RerunReport {
  std::int64_t solves = 0;                                      // solves that were made again
  std::int64_t eligible = 0;                                    // stored solves that could be made again
  std::vector<std::string> external = {}, changed_source = {};  // labels
};
// Makes solves of the stored study again, at most `most`, drawn at random, and tells its progress before each. It makes
// none if the clock may end solves. Throws std::invalid_argument, with the place of the solve, if another bit of the
// answer or another count comes.
RerunReport rerun_sample(const results::Store& store, const results::StoredStudy& study, std::int64_t most,
                         const std::function<void(const Progress&)>& progress = {});

}  // namespace ikbench::experiments
