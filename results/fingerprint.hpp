// One hash of all results of a study, to compare the bits of two machines, compilers or versions in one line.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::results {

// The columns of a fingerprint: questions and answers, not times. New columns of the record are not among them, so a
// store has the same fingerprint in every version of the program.
constexpr std::array<std::string_view, 22> in_fingerprint{"study",
                                                          "robot",
                                                          "solver",
                                                          "series",
                                                          "run",
                                                          "point",
                                                          "target_position_m",
                                                          "target_rotation",
                                                          "start_rad",
                                                          "answer_rad",
                                                          "reached_position_m",
                                                          "position_error_cm",
                                                          "claimed_error_cm",
                                                          "orientation_error",
                                                          "variation_deg",
                                                          "largest_move_deg",
                                                          "limit_violation_deg",
                                                          "evaluations",
                                                          "iterations",
                                                          "stop_reason",
                                                          "status",
                                                          "trace_cm"};

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

// The committed fingerprint of a built-in study (results/reference.inc); empty if there is none.
std::string_view reference_fingerprint(std::string_view study);

}  // namespace ikbench::results
