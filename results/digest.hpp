// Digests: numbers computed from what was written. They show later changes of a store. They do not stop a forger, who
// can compute them anew: nothing in them is secret.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "results/store.hpp"

namespace ikbench::results {

// Each is from 1 to 2^32 - 1, so that their sums fit into 64 bits in any order; 0 means none.
// Digest of a solve: of all columns except its study, which a reader may know by another name, its session, which a
// merge numbers anew, and the digest itself. An unknown column counts as one with its default, or NaN, so a digest
// stays right when later versions add columns.
std::int64_t digest_of(const SolveRecord& record);
// Digest of a solve's place. Without it, a reader of some series and runs would not see that a solve was moved.
std::int64_t digest_of_place(std::string_view study, std::string_view series, std::int64_t run, std::int64_t point);
// Digest of a study without the looks at it.
std::int64_t digest_of(const StudyEntry& study);
// Digest of a session's facts, or of looks: the sum of theirs.
std::int64_t digest_of(const std::map<std::string, std::string>& facts);
// Digest of everything about a session except its solves.
std::int64_t digest_of(const Session& session);

}  // namespace ikbench::results
