// The commands. Each adds itself to the program and sets its exit code: 0 done, 1 a user's mistake or a damaged store,
// 2 our mistake or the system's, 3 a regression, 4 and 5 undecided, 128 + the number of the signal that stopped it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace ikbench::cli {

// The typed command, as a shell would take it again, and its exit code.
struct Invocation {
  std::string command;
  int exit_code = 0;
};

void add_reproduce(CLI::App& app, Invocation& invocation);
void add_run(CLI::App& app, Invocation& invocation);
void add_merge(CLI::App& app, Invocation& invocation);
void add_submit(CLI::App& app, Invocation& invocation);
void add_status(CLI::App& app, Invocation& invocation);
void add_report(CLI::App& app);
void add_stats(CLI::App& app, Invocation& invocation);
void add_audit(CLI::App& app);
void add_multiverse(CLI::App& app, Invocation& invocation);
void add_compare(CLI::App& app, Invocation& invocation);
void add_list(CLI::App& app);
void add_robot(CLI::App& app);
void add_solve(CLI::App& app);
void add_export(CLI::App& app);
void add_import(CLI::App& app, Invocation& invocation);
void add_fingerprint(CLI::App& app);
void add_check_solver(CLI::App& app, Invocation& invocation);
void add_host(CLI::App& app);

}  // namespace ikbench::cli
