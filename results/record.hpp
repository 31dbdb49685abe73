// One row per solve: everything that is remembered of it. The columns are listed once, in columns.inc; this struct,
// the store's schema, its reader, CSV, JSON and `ikbench list columns` derive from that list.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::results {

// Why a solve ended; finished: by the solver itself.
enum class StopReason : std::uint8_t { iterations, tolerance, evaluations, time, not_finite, finished };

// What the verifier says of an answer; the first that applies, in the order of severity
// not_finite, claimed_but_wrong, refused, limit_violated, tolerance_missed, ok. Where a study enforces the joint
// limits, an answer that violates them is refused: the arm stays where it was, and the record's answer is that.
// The others, up to declined, are of programs that solve outside of this one and gave no answer; the arm stays where
// it was, too.
enum class Status : std::uint8_t {
  ok,
  tolerance_missed,
  limit_violated,
  refused,
  claimed_but_wrong,
  not_finite,
  crashed,         // it ended or could not be started, or ended too often and is given up
  timed_out,       // it did not answer within its patience
  broke_protocol,  // it said what makes no sense
  declined,        // it says that it cannot solve this
  not_verified,    // of somebody else's solve of which the error is known, but not the answer
  over_budget      // of a program: in order, but for far more time or evaluations than the study gives
};

// Under what circumstances the times were taken; only `clean` times are comparable, and `process`, those of another
// program, which have its transport in them. imported: taken elsewhere, of a solve from a file (`ikbench import`).
enum class Timing : std::uint8_t { clean, parallel, debug_build, process, imported };

// Who counted the evaluations.
enum class CountedBy : std::uint8_t { suite, solver, nobody };

constexpr std::array<std::string_view, 6> stop_reason_names{"iterations", "tolerance",  "evaluations",
                                                            "time",       "not_finite", "finished"};
constexpr std::array<std::string_view, 12> status_names{
    "ok",      "tolerance_missed", "limit_violated", "refused",  "claimed_but_wrong", "not_finite",
    "crashed", "timed_out",        "broke_protocol", "declined", "not_verified",      "over_budget"};
constexpr std::array<std::string_view, 5> timing_names{"clean", "parallel", "debug_build", "process", "imported"};
constexpr std::array<std::string_view, 3> counted_by_names{"suite", "solver", "nobody"};

constexpr const auto& names_of(StopReason) { return stop_reason_names; }
constexpr const auto& names_of(Status) { return status_names; }
constexpr const auto& names_of(Timing) { return timing_names; }
constexpr const auto& names_of(CountedBy) { return counted_by_names; }

// Whether the solver gave no answer at all.
constexpr bool is_without_answer(Status status) { return status >= Status::crashed && status <= Status::declined; }
// Whether the arm stayed where it was, and the record's answer is that.
constexpr bool stays(Status status) { return status == Status::refused || is_without_answer(status); }

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  return names_of(value)[static_cast<std::size_t>(value)];
}

// The key of a series is CONFIGURATION@SOURCE: a hash of what the study asks for, and one of the code that solved it.
constexpr char before_source = '@';
constexpr std::string_view configuration_of(std::string_view series) {
  return series.substr(0, series.find(before_source));
}

struct SolveRecord {
#define COLUMN(type, name, initial, meaning) type name = initial;
#include "results/columns.inc"
#undef COLUMN
};

// visit(name, member, meaning) for every column, in their order.
template <class Visit>
constexpr void for_each_column(Visit&& visit) {
#define COLUMN(type, name, initial, meaning) visit(#name, &SolveRecord::name, meaning);
#include "results/columns.inc"
#undef COLUMN
}

}  // namespace ikbench::results
