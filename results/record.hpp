// One row per solve: everything that the store keeps of it. columns.inc lists the columns once; this struct, the
// store's schema, its reader, CSV and `ikbench list columns` derive from that list.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "numerics/stop_rule.hpp"

namespace ikbench::results {

using numerics::StopReason;

// The verifier's judgement of an answer: the first that applies of not_finite, claimed_but_wrong, refused,
// limit_violated, tolerance_missed, ok; the last may become invalid by the study's own check. From crashed on there is
// none in time: the arm stays where it was, and so does the record's answer.
enum class Status : std::uint8_t {
  ok,                 // within the tolerance, if there is one
  invalid,            // the same, but the study's own check refuses it
  tolerance_missed,   // farther off
  limit_violated,     // a joint is outside its limits, which the study only records
  refused,            // the same where the study enforces them: the arm stays
  claimed_but_wrong,  // the solver says another error than its answer has
  not_finite,         // no numbers, or an arithmetic that differs from the C library's
  crashed,            // the program ended, could not be started, or was given up
  timed_out,          // it did not answer within its patience
  broke_protocol,     // its message made no sense
  declined,           // it says that it cannot solve this
  over_budget         // a program or library took far more time or evaluations than the study gives
};

// The circumstances of a solve's times. Only `clean` times are comparable, and `process`, those of another program,
// which include its messages. batch: the time of a batch, divided by its size, wherever that was solved.
enum class Timing : std::uint8_t { clean, parallel, debug_build, process, batch };

// Tells who counted the evaluations.
enum class CountedBy : std::uint8_t { suite, solver, nobody };

constexpr std::array<std::string_view, 12> names_of(Status) {
  return {"ok",         "invalid", "tolerance_missed", "limit_violated", "refused",  "claimed_but_wrong",
          "not_finite", "crashed", "timed_out",        "broke_protocol", "declined", "over_budget"};
}
constexpr std::array<std::string_view, 5> names_of(Timing) {
  return {"clean", "parallel", "debug_build", "process", "batch"};
}
constexpr std::array<std::string_view, 3> names_of(CountedBy) { return {"suite", "solver", "nobody"}; }

// The least time [s] that a program may tell of a solve that took so much processor time [s]: with two threads, and a
// millisecond of messages.
constexpr double least_told(double cpu_seconds) { return cpu_seconds / 2.2 - 0.001; }

// True if the solver gave no answer within its budget.
constexpr bool is_without_answer(Status status) { return status >= Status::crashed; }
// True if the arm stayed where it was, and the record's answer is that.
constexpr bool stays(Status status) { return status == Status::refused || is_without_answer(status); }
// True if the verifier finds the target reached.
constexpr bool is_reached(Status status) { return status == Status::ok || status == Status::invalid; }
// Nothing is wrong with the answer, near enough or not.
constexpr bool is_in_order(Status status) { return status == Status::ok || status == Status::tolerance_missed; }

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
  std::map<std::string, double> extras = {};  // numbers of the solver's own, by name; in a table of their own
};

using TakeSolve = std::function<void(const SolveRecord&)>;

// Calls visit(name, member, meaning) for every column, in their order.
template <class Visit>
constexpr void for_each_column(Visit&& visit) {
#define COLUMN(type, name, initial, meaning) visit(#name, &SolveRecord::name, meaning);
#include "results/columns.inc"
#undef COLUMN
}

// Says the first number that no solve has, "seconds is 0"; empty: there is none. Only an error that is claimed may be
// below 0. No time is infinite, and the wall time is not 0, since it divides and has a logarithm; where there is no
// time it is NaN.
inline std::string wrong_number(const SolveRecord& solve) {
  std::string found;
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*member, std::string_view) {
    if constexpr (std::is_arithmetic_v<Value>) {
      const auto value = static_cast<double>(solve.*member);
      const bool is_below = value < 0 && name != "claimed_error_cm";
      const bool is_no_time = name.ends_with("seconds") && std::isinf(value);
      if (found.empty() && (is_below || is_no_time || (name == "seconds" && value == 0)))
        found = fmt::format("{} is {}", name, value);
    }
  });
  return found;
}

}  // namespace ikbench::results
