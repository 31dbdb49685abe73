// One hash of all results of a study, to compare the bits of two machines, compilers or versions in one line, and one
// of all that a store holds, to see whether it was changed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::results {

// Calls visit(name, member) for every column of a fingerprint: questions and answers, which stand before the times, and
// the trace. New columns of the record come after these, so a store has the same fingerprint in every version.
template <class Visit>
constexpr void for_each_column_of_fingerprint(Visit&& visit) {
  bool is_before_times = true;
  for_each_column([&](std::string_view name, auto member, std::string_view) {
    is_before_times = is_before_times && name != "seconds";
    if (is_before_times || name == "trace_cm") visit(name, member);
  });
}

// 32 hexadecimal digits, the same for records in any order. Every bit of a number counts, with two exceptions, because
// a store cannot tell them apart: all NaN are the same, and -0.0 outside of lists is 0.0. Of the series only the
// configuration counts, not the source that gave the bits.
std::string fingerprint(std::vector<SolveRecord> records);

struct Fingerprint {
  std::string text;
  std::int64_t solves = 0;
};
// That of a study's solves in a store, read one by one.
Fingerprint fingerprint(const Store& store, StoredStudy study);

// A line to cite: "mine: 600 of 600 solves (runs x targets x solvers: 100 x 1 x 6), fingerprint 0123...".
std::string fingerprint_line(const Store& store, const StoredStudy& study);

// The SHA-256 digest of all that a store holds, times, sessions and extras too, but for the fact that keeps it in an
// archive: who has seen it elsewhere can tell that no row was changed.
std::string seal_of(const Store& store);
constexpr std::string_view seal_fact = "seal";
// Archives used to keep a fingerprint_line of each study instead, under this name and the study's.
constexpr std::string_view fingerprint_fact = "seal.";

// The committed fingerprint of a built-in study (results/reference.inc); empty if there is none.
std::string_view reference_fingerprint(std::string_view study);

}  // namespace ikbench::results
