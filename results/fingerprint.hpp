// One hash of all results of a study, to say in a line whether two machines, compilers or versions gave the same bits.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"

namespace ikbench::results {

// Columns that differ from one run of the program to the next; every other is part of the fingerprint.
constexpr std::array<std::string_view, 4> not_in_fingerprint{"seconds", "cpu_seconds", "timing", "session"};

// 32 hexadecimal digits, the same for records in any order. Numbers count with every bit, with two exceptions: every
// NaN is the same, and -0.0 is 0.0 where it is not in a list, because a store cannot tell them apart. Of the series the
// configuration counts: which source gave the bits says nothing of them.
std::string fingerprint(std::vector<SolveRecord> records);

// The committed fingerprint of a built-in study (results/reference.inc); empty where there is none.
std::string_view reference_fingerprint(std::string_view study);

}  // namespace ikbench::results
