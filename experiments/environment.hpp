// Facts about the program, the compiler and the machine, as text by name.
#pragma once

#include <map>
#include <string>

namespace ikbench::experiments {

std::map<std::string, std::string> environment();
// Time [s] that the host of a virtual machine took from all its processors since it started (/proc/stat: steal). NaN if
// unknown.
double stolen_seconds();
double thread_seconds();  // processor time [s] of this thread
// Times of a debug or sanitized build say nothing about a solver.
bool is_debug_build();
std::string version();       // "1.0.0 (COMMIT, source DIGEST)"
std::string program_name();  // "ikbench", with its version, for what it writes

}  // namespace ikbench::experiments
