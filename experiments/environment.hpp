// Facts about the program, the compiler and the machine, as text by name.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>

namespace ikbench::experiments {

std::map<std::string, std::string> environment();
// Processor time [s] that the host of a virtual machine has kept from it since it started (steal, /proc/stat), of all
// processors; NaN where that is not told.
double stolen_seconds();
double thread_seconds();  // processor time [s] of this thread
// How long [s] all threads of a process, or one (/proc/thread-self), were ready to run and had no processor; NaN where
// that is not told.
double waited_seconds(pid_t process);
double waited_seconds(const std::filesystem::path& task);
// Times of a debug or sanitized build say nothing about a solver.
bool is_debug_build();
std::string version();

}  // namespace ikbench::experiments
