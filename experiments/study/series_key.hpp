// The identity of stored solves. A series is all solves of a solver entry, and its key is a hash of everything that
// decides their numbers. `run` solves what the store lacks of a series; `verify` and reports compare the keys.
#pragma once

#include <string>
#include <vector>

#include "experiments/study/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Returns the hash of everything in the study that decides the numbers of one solver, in 16 hexadecimal digits. It
// draws fixed targets, which takes time.
std::string configuration_key(const Study& study, const SolverEntry& entry);
// Returns the digest of the source of the entry's solver: the source file of a built-in one, the running executable for
// a custom one, or the executable and files of a program.
std::string source_digest_of(const SolverEntry& entry);
// Returns the library of a peer, with its version; empty for other solvers.
std::string library_name(const SolverEntry& entry);
// Returns the part of the entry's keys that is made of the shared sources, the solver's source and a peer's library.
std::string source_key(const SolverEntry& entry);
// Returns the same from the digests of the shared sources and of the solver's own, and the name of its library.
std::string source_key_of(const std::string& shared, const std::string& own, const std::string& library = "");
// Returns configuration_key and source_key, with a hash of the study's check if there is one. Equal keys mean equal
// numbers on one machine, unless a solve ends by its wall time.
std::string series_key(const Study& study, const SolverEntry& entry);

// Returns one series per solver entry, in the order of the entries, as the store keeps them. Each key costs a
// configuration_key, so a run makes the series once.
std::vector<results::Series> series_of(const Study& study);

}  // namespace ikbench::experiments
