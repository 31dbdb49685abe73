// `ikbench host`: this program as the child that has loaded a shared object, and speaks the protocol of programs for
// it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/foreign/protocol.hpp"

namespace ikbench::experiments {

// The command that hosts a solver of a shared object; `name`: of one of its solvers, or empty: the first.
std::vector<std::string> host_command(const std::string& object, const std::string& name);

// Until it is told bye, on standard input and output, which the object does not get: what it prints goes to standard
// error. std::invalid_argument where the object is not what it should be; what a solver throws goes on.
void host(const std::filesystem::path& object, const std::string& name);

}  // namespace ikbench::experiments
