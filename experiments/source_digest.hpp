// What the source says that decides numbers, as digests that the build makes: a solver that was edited is told from the
// one before. Comments and white space are no part of them.
#pragma once

#include <string>
#include <string_view>

namespace ikbench::experiments {

// Of all of it.
std::string source_digest();
// Of what all solvers share: arms, kernels, random numbers, the loop, targets, the verifier (CMakeLists.txt lists it).
std::string shared_source_digest();
// Of a registered solver's own file.
std::string solver_source_digest(std::string_view solver);

}  // namespace ikbench::experiments
