// One hash of all results of a study, to say in a line whether two machines, compilers or versions gave the same bits.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"

namespace ikbench::results {

// The columns that a fingerprint covers: what was asked and what came out, not how long it took. A column that is added
// to the record is not among them, so that a store has the same fingerprint in every version of the program.
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

// 32 hexadecimal digits, the same for records in any order. Numbers count with every bit, with two exceptions: every
// NaN is the same, and -0.0 is 0.0 where it is not in a list, because a store cannot tell them apart. Of the series the
// configuration counts: which source gave the bits says nothing of them.
std::string fingerprint(std::vector<SolveRecord> records);

// The committed fingerprint of a built-in study (results/reference.inc); empty where there is none.
std::string_view reference_fingerprint(std::string_view study);

}  // namespace ikbench::results
