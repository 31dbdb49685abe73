// Digests of the source that decides numbers, made by the build, so that an edited solver differs from the one before.
// Comments and white space do not count.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::experiments {

// Digest of all of it.
std::string source_digest();
// Digest of what all solvers share: arms, kernels, random numbers, the loop, targets, the verifier (CMakeLists.txt
// lists it).
std::string shared_source_digest();
// Digest of a registered solver's own file.
std::string solver_source_digest(std::string_view solver);

}  // namespace ikbench::experiments
