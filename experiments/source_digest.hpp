// What was built. Digests of the source that decides numbers, so that an edited solver differs from the one before;
// comments and white space do not count.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace ikbench::experiments {

// build_type, commit, flags, sanitizers, source (the shared digest), version.
std::map<std::string, std::string> build_facts();

// Digest of all of it.
std::string source_digest();
// Digest of what all solvers share: arms, kernels, random numbers, the loop, targets, the verifier (CMakeLists.txt
// lists it).
std::string shared_source_digest();
// Digest of a registered solver's own file.
std::string solver_source_digest(std::string_view solver);

}  // namespace ikbench::experiments
