// Facts about the program, the compiler and the machine, as text by name.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>

namespace ikbench::experiments {

std::map<std::string, std::string> environment();
// Processor time [s] that the host of a virtual machine took from all its processors since it started (steal,
// /proc/stat); NaN if unknown.
double stolen_seconds();
double thread_seconds();  // processor time [s] of this thread
// Time [s] for which all threads of a process, or one task (/proc/thread-self), were ready to run without a processor;
// NaN if unknown.
double waited_seconds(pid_t process);
double waited_seconds(const std::filesystem::path& task);
// Times of a debug or sanitized build say nothing about a solver.
bool is_debug_build();
std::string version();

}  // namespace ikbench::experiments
