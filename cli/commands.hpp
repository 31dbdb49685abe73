// The commands, in the order of --help: a line in commands.inc and a file each, which defines the function below. It
// adds the command to the program and sets its exit code: 0 done, 1 a user's mistake or a damaged store, 2 our mistake
// or the system's, 3 a regression, 4 and 5 undecided, 128 + the number of the signal that stopped it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace ikbench::cli {

// The typed command, as a shell would take it again, and its exit code.
struct Invocation {
  std::string command;
  int exit_code = 0;
};

#define COMMAND(name) void add_##name(CLI::App& app, Invocation& invocation);
#include "cli/commands.inc"
#undef COMMAND

}  // namespace ikbench::cli
