// The commands. One is a line in commands.inc, in the order of --help, and a file, which defines
// void add_NAME(CLI::App&, Invocation&). It adds itself to the program and sets its exit code: 0 done, 1 a user's
// mistake or a damaged store, 2 our mistake or the system's, 3 a regression, 4 not decided, 5 solves are
// missing, 128 + the number of the signal that stopped it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <utility>

#include "numerics/json.hpp"

namespace ikbench::cli {

// The typed command, as a shell would take it again, and its exit code.
struct Invocation {
  std::string command;
  int exit_code = 0;
};

// The names of figures, and the keys of their look.
std::string help_of_figures();

// Checks of options, and JSON as an answer.

// Accepts a decimal number in the range: CLI11 accepts more texts as numbers.
CLI::Validator number_in(std::pair<double, double> range);

constexpr std::int64_t largest_whole = 999'999'999'999'999'999;
// Accepts numbers in the range, written in decimal digits only: CLI11 alone reads 010 as 8 and takes what is too large
// for the largest.
CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range = {0, largest_whole});

// Refuses an empty folder name: it comes from an unset variable of a script.
CLI::Validator not_empty();

void add_json_option(CLI::App& command, bool& is_json);
void show_json(const numerics::OrderedJson& json);

}  // namespace ikbench::cli
