// Two hashes: a fingerprint of all results of a study, to compare the bits of two machines, compilers or versions in
// one line; and a seal of all that a store holds, to see whether it was changed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::results {

// Calls visit(name, member) for every column of a fingerprint: questions and answers, which stand before the times, and
// the trace. A new column of the record has to stand behind these, so that a store has the same fingerprint in every
// version.
template <class Visit>
constexpr void for_each_column_of_fingerprint(Visit&& visit) {
  bool is_before_times = true;
  for_each_column([&](std::string_view name, auto member, std::string_view) {
    is_before_times = is_before_times && name != "seconds";
    if (is_before_times || name == "trace_cm") visit(name, member);
  });
}

// Returns 32 hexadecimal digits that do not depend on the order of the records. Every bit of every number counts,
// except that all NaN are one, and -0.0 outside of lists equals 0.0: a store cannot tell these apart. Of a series' key
// only the configuration counts, not the source that gave the bits.
std::string fingerprint(std::vector<SolveRecord> records);

struct Fingerprint {
  std::string text;
  std::int64_t solves = 0;
};
// Returns the fingerprint of a study's solves in a store. Solves are read one by one, so memory does not grow with
// them.
Fingerprint fingerprint(const Store& store, StoredStudy study);

// Returns a line to cite: "mine: 600 of 600 solves (runs x targets x solvers: 100 x 1 x 6), fingerprint 0123...".
std::string fingerprint_line(const Store& store, const StoredStudy& study);

// Returns the SHA-256 digest of all that a store holds, times, sessions and extras too, except the fact that keeps the
// seal in an archive. A reader who has seen the digest elsewhere can tell that no row was changed.
std::string seal_of(const Store& store);
constexpr std::string_view seal_fact = "seal";
// The beginning of a fact of older archives, which kept a `fingerprint_line` of each study instead of a seal.
constexpr std::string_view fingerprint_fact = "seal.";

// Returns the committed fingerprint of a built-in study (results/reference.inc); empty if there is none.
std::string_view reference_fingerprint(std::string_view study);

}  // namespace ikbench::results
