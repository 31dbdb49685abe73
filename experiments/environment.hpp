// Facts about the program, the compiler and the machine, as text by name.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace ikbench::experiments {

std::map<std::string, std::string> environment();
// Processor time [s] that the host of a virtual machine has kept from it since it started (steal, /proc/stat), of all
// processors; NaN where that is not told.
double stolen_seconds();
double thread_seconds();  // processor time [s] of this thread
// How long [s] a process ("123"), or this thread ("thread-self"), was ready to run and had no processor; NaN where that
// is not told.
double waited_seconds(std::string_view process);
// Times of a debug or sanitized build say nothing about a solver.
bool is_debug_build();
std::string version();

}  // namespace ikbench::experiments
