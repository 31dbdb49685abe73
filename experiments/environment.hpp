// Facts about the program, the compiler and the machine, as text by name.
#pragma once

#include <limits>
#include <map>
#include <string>

namespace ikbench::experiments {

std::map<std::string, std::string> environment();
// Time [s] of all the machine's processors together since it started (/proc/stat): in which they had nothing to do, and
// which the host of a virtual machine took from them (steal). NaN if unknown.
struct ProcessorSeconds {
  double idle = std::numeric_limits<double>::quiet_NaN(), stolen = std::numeric_limits<double>::quiet_NaN();
};
ProcessorSeconds processor_seconds();
double thread_seconds();  // processor time [s] of this thread
// Times of a debug or sanitized build say nothing about a solver.
bool is_debug_build();
std::string version();       // "1.0.0 (COMMIT, source DIGEST)"
std::string program_name();  // "ikbench", with its version, for what it writes

}  // namespace ikbench::experiments
