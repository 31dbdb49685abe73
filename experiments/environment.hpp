// Facts about the program, the compiler and the machine, as text by name: each session of a store keeps them. And
// digests of the sources that decide numbers, for the keys of series, so that an edited solver differs from the one
// before. Comments and white space do not count (source_digests.cmake).
#pragma once

#include <filesystem>
#include <istream>
#include <map>
#include <string>
#include <string_view>

namespace ikbench::experiments {

// Returns all facts by name.
std::map<std::string, std::string> environment();
// Returns the processor's name in /proc/cpuinfo, or "unknown". On ARM the kernel knows no name, so the numbers of maker
// and part are returned.
std::string cpu_model(std::istream&& info);
double thread_cpu_seconds();  // processor time [s] of this thread
// Returns true for a debug or sanitized build, whose times say nothing about a solver.
bool is_debug_build();
std::filesystem::path executable_path();  // the file that runs
std::string program_name();               // "ikbench 1.0.0 (COMMIT, source DIGEST)", for the files that it writes
// Returns the digest of the sources that all solvers share: arms, kernels, random numbers, the loop, targets, the
// verifier. CMakeLists.txt lists them.
std::string shared_source_digest();
// Returns the digest of a registered solver's own file. Throws std::logic_error for another name.
std::string solver_source_digest(std::string_view solver);

}  // namespace ikbench::experiments
