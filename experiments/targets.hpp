// The targets of a study as CSV, for solvers that run elsewhere, and the digest by which their answers name a target.
// `ikbench run` writes them where a study waits for answers, `ikbench export --format targets` from a store.
#pragma once

#include <string>
#include <vector>

#include "base/files.hpp"
#include "experiments/study/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Returns the 16 hexadecimal digits that stand for a target and its start.
std::string target_digest(const Pose& target, const Configuration& start);

// Returns the start of each target of a run. The study must not be chained.
std::vector<Configuration> all_starts_of_run(const Study& study, const Robot& arm, int run);

// Writes a header, and a row per target: run, point, target (its digest), x, y, z [m], qx, qy, qz, qw, and the start of
// each joint [rad, m]. Throws std::invalid_argument for a chained study, whose starts are answers.
void write_targets(const Study& study, const base::Write& write);
// Writes the same from the solves of a store, which has no other targets.
void write_targets(const results::Store& store, const results::StoredStudy& study, const base::Write& write);

}  // namespace ikbench::experiments
