// The commands. One is a line in commands.inc, in the order of --help, and a file, which defines
// void add_NAME(CLI::App&, Invocation&). It adds itself to the program and sets its exit code: 0 done, 1 a user's
// mistake or a damaged store, 2 our mistake or the system's, 3 a regression, 4 not decided, 5 solves are
// missing, 128 + the number of the signal that stopped it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace ikbench::cli {

// The typed command, as a shell would take it again, and its exit code.
struct Invocation {
  std::string command;
  int exit_code = 0;
};

}  // namespace ikbench::cli
