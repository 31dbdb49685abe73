// Digests: numbers that follow from what was written. They show that a store was changed afterwards. They prove nothing
// against who makes them anew: nothing in them is secret.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "results/store.hpp"

namespace ikbench::results {

// Each is from 1 to 2^32 - 1, so that sums of them fit into 64 bits whatever their order; 0 stands for none.
// Of a solve: all columns but its study, which who reads it may know by another name, its session, which a merge
// numbers anew, and the digest itself. A column that a program does not know counts as one that has its default, or
// NaN: so a digest stays right where later versions add columns.
std::int64_t digest_of(const SolveRecord& record);
// Of its place, without which who reads some series and runs would not see that a solve was moved to others.
std::int64_t digest_of_place(std::string_view study, std::string_view series, std::int64_t run, std::int64_t point);
// But for the looks at it.
std::int64_t digest_of(const StudyEntry& study);
// Of facts of a session, or of looks: the sum of theirs.
std::int64_t digest_of(const std::map<std::string, std::string>& facts);
// Of all that is known of a session but its solves.
std::int64_t digest_of(const Session& session);

}  // namespace ikbench::results
