// The solve record: everything that the store keeps of one solve. The runner makes it, the store keeps it, and reports
// read it. columns.inc lists the columns once; this struct, the store's schema, its reader, CSV and `ikbench list
// columns` derive from that list.
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

// The verifier's judgement of an answer. It is the first that applies of not_finite, misreported, refused,
// limit_violated, tolerance_missed, ok; the study's own check may turn ok into invalid. From crashed on there was no
// answer in time: the arm stays where it was, and the record's answer is that place.
enum class Status : std::uint8_t {
  ok,                // within the tolerance, if there is one
  invalid,           // within the tolerance, but the study's own check refuses it
  tolerance_missed,  // farther off than the tolerance
  limit_violated,    // a joint is outside its limits, which the study only records
  refused,           // a joint is outside its limits, which the study enforces: the arm stays
  misreported,       // the solver reports another error than its answer has
  not_finite,        // the answer is not finite, or sines differ from the C library's
  crashed,           // the program ended, could not be started, or was given up
  timed_out,         // the program did not answer within its timeout
  protocol_error,    // the program's message broke the protocol
  declined,          // the program says that it cannot solve this
  over_budget        // a program or library took far more time or evaluations than the study gives
};

// The circumstances in which a solve was timed. Only `clean` times can be compared, and `process` ones, those of
// another program, which include its messages. `batch`: the time of a batch divided by its size, wherever it was
// solved. `elsewhere`: the answer was made outside this program, which timed nothing. `process_warm`: another program
// solved the target twice in a row in its own process, and timed the second solve.
enum class Timing : std::uint8_t { clean, parallel, debug_build, process, batch, elsewhere, process_warm };

// The side that counted the evaluations: ikbench, the solver itself, or none.
enum class CountedBy : std::uint8_t { ikbench, solver, none };

constexpr std::array<std::string_view, 12> names_of(Status) {
  return {"ok",         "invalid", "tolerance_missed", "limit_violated", "refused",  "misreported",
          "not_finite", "crashed", "timed_out",        "protocol_error", "declined", "over_budget"};
}
constexpr std::array<std::string_view, 7> names_of(Timing) {
  return {"clean", "parallel", "debug_build", "process", "batch", "elsewhere", "process_warm"};
}
constexpr std::array<std::string_view, 3> names_of(CountedBy) { return {"ikbench", "solver", "none"}; }

// Returns true if another program made the solve, alone in its message.
constexpr bool is_of_process(Timing timing) { return timing == Timing::process || timing == Timing::process_warm; }
// Returns true if the time is of one solve in a release build, without others beside it.
constexpr bool is_timed_alone(Timing timing) { return timing == Timing::clean || is_of_process(timing); }

// Returns true if the solver gave no answer within its budget.
constexpr bool has_no_answer(Status status) { return status >= Status::crashed; }
// Returns true if the arm stayed where it was, which is then the record's answer.
constexpr bool arm_stays(Status status) { return status == Status::refused || has_no_answer(status); }
// Returns true if the verifier finds the target reached.
constexpr bool is_reached(Status status) { return status == Status::ok || status == Status::invalid; }
// Returns true if nothing is wrong with the answer, whether it is near enough or not.
constexpr bool is_sound(Status status) { return status == Status::ok || status == Status::tolerance_missed; }

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  return names_of(value)[static_cast<std::size_t>(value)];
}

// The beginnings of the names of facts of a session that are about the answers of a series, whose key follows: why they
// miss their targets, and other sentences on a file of answers.
inline const std::string cause_fact = "cause.", answers_fact = "answers.";

// The key of a series is CONFIGURATION@SOURCE: a hash of what the study asks for, and a hash of the code that solved
// it.
constexpr char source_separator = '@';
// Returns the part of a key before the source.
constexpr std::string_view configuration_part(std::string_view series) {
  return series.substr(0, series.find(source_separator));
}

struct SolveRecord {
#define COLUMN(type, name, initial, meaning) type name = initial;
#include "results/columns.inc"
#undef COLUMN
  std::map<std::string, double> extras = {};  // the solver's own numbers, by name; the store has a table for them
};

using SolveVisitor = std::function<void(const SolveRecord&)>;

// Calls visit(name, member, meaning) for every column, in the order of columns.inc.
template <class Visit>
constexpr void for_each_column(Visit&& visit) {
#define COLUMN(type, name, initial, meaning) visit(#name, &SolveRecord::name, meaning);
#include "results/columns.inc"
#undef COLUMN
}

// Returns the first impossible number, such as "seconds is 0"; empty if there is none. Only a reported error may be
// negative, and no time is infinite: a missing one is NaN. The wall time is not 0, because it divides and has a
// logarithm.
inline std::string wrong_number(const SolveRecord& solve) {
  std::string found;
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*member, std::string_view) {
    if constexpr (std::is_arithmetic_v<Value>) {
      const auto value = static_cast<double>(solve.*member);
      const bool is_below = value < 0 && name != "reported_error_cm";
      const bool is_wall_time = name == "seconds" || name == "wall_seconds";
      const bool is_no_time = name.ends_with("seconds") && std::isinf(value);
      if (found.empty() && (is_below || is_no_time || (is_wall_time && value == 0)))
        found = fmt::format("{} is {}", name, value);
    }
  });
  return found;
}

}  // namespace ikbench::results
