// Facts about the program, the compiler and the machine, as text by name. Digests of the source that decides numbers,
// so that an edited solver differs from the one before; comments and white space do not count.
#pragma once

#include <filesystem>
#include <istream>
#include <map>
#include <string>
#include <string_view>

namespace ikbench::experiments {

std::map<std::string, std::string> environment();
// The processor's name in /proc/cpuinfo; on ARM, where the kernel knows none, the numbers of its maker and part.
std::string cpu_model(std::istream&& info);
double thread_seconds();  // processor time [s] of this thread
// Times of a debug or sanitized build say nothing about a solver.
bool is_debug_build();
std::filesystem::path own_program();  // the file that runs
std::string program_name();           // "ikbench 1.0.0 (COMMIT, source DIGEST)", for what it writes
// Digest of what all solvers share: arms, kernels, random numbers, the loop, targets, the verifier (CMakeLists.txt
// lists it).
std::string shared_source_digest();
// Digest of a registered solver's own file.
std::string solver_source_digest(std::string_view solver);

}  // namespace ikbench::experiments
