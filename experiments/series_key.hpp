// The keys under which solves are remembered: what decides the numbers of one solver of a study, as a hash.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "experiments/fields.hpp"
#include "experiments/study.hpp"

namespace ikbench::experiments {

// Leads a Fields along all fields of something.
using FieldList = std::function<void(Fields&)>;

// What a key says of fields by their names: "\nPREFIXname value" for each that is not as the defaults have it.
std::string said_by_name(const FieldList& fields, const FieldList& defaults, std::string_view prefix = "");

// Hash of everything in the study that decides the numbers of one solver.
std::string configuration_key(const Study& study, const SolverEntry& entry);
// Of what the entry's solver is made of: its source file, or a program's executable and files.
std::string source_digest_of(const SolverEntry& entry);
// Of a peer: its library with the version; else empty.
std::string library_of(const SolverEntry& entry);
// That, and a hash of the source that makes them, of a peer with its library: equal keys, equal numbers, on one machine
// and unless a solve ends by its wall time.
std::string series_key(const Study& study, const SolverEntry& entry);

}  // namespace ikbench::experiments
