// The commands: each adds itself to the program and says its exit code (0 done, 1 the user's mistake, 2 ours,
// 130 stopped by Ctrl-C).
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>

namespace ikbench::cli {

// CLI::NonNegativeNumber prints its upper bound with 309 digits.
inline CLI::Range non_negative() { return {std::int64_t{0}, std::numeric_limits<std::int64_t>::max()}; }

void add_reproduce(CLI::App& app, int& exit_code);
void add_run(CLI::App& app, int& exit_code);
void add_report(CLI::App& app);
void add_list(CLI::App& app);
void add_solve(CLI::App& app);
void add_export(CLI::App& app);

}  // namespace ikbench::cli
