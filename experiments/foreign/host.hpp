// `ikbench host`: this program as a child process that loads a shared object and speaks the protocol of programs for
// it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/foreign/protocol.hpp"

namespace ikbench::experiments {

// The command that hosts a solver of a shared object. `name` selects one of its solvers; empty: the first.
std::vector<std::string> host_command(const std::string& object, const std::string& name);

// Serves standard input and output until "bye". What the object prints goes to standard error. Throws
// std::invalid_argument if the object is invalid, and passes on what a solver throws.
void host(const std::filesystem::path& object, const std::string& name);

}  // namespace ikbench::experiments
