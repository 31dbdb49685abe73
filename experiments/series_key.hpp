// The keys of stored solves: a hash of everything that decides the numbers of one solver of a study.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "experiments/fields.hpp"
#include "experiments/study.hpp"

namespace ikbench::experiments {

// Shows a Fields all fields of something.
using FieldList = std::function<void(Fields&)>;

// The part of a key that names fields: "\nPREFIXname value" for each field that differs from its default.
std::string said_by_name(const FieldList& fields, const FieldList& defaults, std::string_view prefix = "");

// Hash of everything in the study that decides the numbers of one solver.
std::string configuration_key(const Study& study, const SolverEntry& entry);
// Digest of the source of the entry's solver: its source file, or a program's executable and files.
std::string source_digest_of(const SolverEntry& entry);
// The library of a peer, with its version; empty for other solvers.
std::string library_of(const SolverEntry& entry);
// configuration_key with a hash of the source that makes the numbers, and of a peer's library. Equal keys mean equal
// numbers on one machine, unless a solve ends by its wall time.
std::string series_key(const Study& study, const SolverEntry& entry);

}  // namespace ikbench::experiments
