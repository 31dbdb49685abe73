// Writes a study as text: TOML to edit and run, JSON for the store, and the keys of stored solves, a hash of everything
// that decides the numbers of one solver of a study.
#pragma once

#include <string>

#include "experiments/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// The whole study; parse_study gives the same study back.
std::string to_toml(const Study& study);
// A path, as in the study's table [path].
std::string to_toml(Path path);
// A look, as in [figures].
std::string to_toml(results::FigureStyle style);
// The study without its solvers, with its number of points and its arm, as the store keeps it.
std::string to_json(const Study& study);
// The arm's links, base and tool, as in its file.
std::string to_json(const robots::Robot& arm);
// A plan, as in the definition at "/analysis".
std::string to_json(results::Plan plan);

// Hash of everything in the study that decides the numbers of one solver.
std::string configuration_key(const Study& study, const SolverEntry& entry);
// Digest of the source of the entry's solver: its source file, or a program's executable and files.
std::string source_digest_of(const SolverEntry& entry);
// The library of a peer, with its version; empty for other solvers.
std::string library_of(const SolverEntry& entry);
// configuration_key with a hash of the source that makes the numbers, and of a peer's library. Equal keys mean equal
// numbers on one machine, unless a solve ends by its wall time.
std::string series_key(const Study& study, const SolverEntry& entry);

// The solvers' parts of the study, and all of it, as the store keeps them. A key is a hash of all targets, so a run
// makes it once.
std::vector<results::Series> series_of(const Study& study);
results::StoredStudy stored_study(const Study& study);

}  // namespace ikbench::experiments
