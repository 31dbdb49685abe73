// What commands are, checks of options, options that commands share, and JSON as an answer.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/json.hpp"
#include "robots/robot.hpp"

namespace ikbench::cli {

// The commands. One is a line in commands.inc, in the order of --help, with what it is used for, and a file, which
// defines void add_NAME(CLI::App&, Invocation&). It adds itself to the program and sets its exit code: 0 done, 1 a
// user's mistake or a damaged store, 2 our mistake or the system's, 3 something is worse or never answers, 4 not
// decided, 5 solves are missing, 128 + the number of the signal that stopped it.
struct Invocation {
  std::string command;  // as typed, as a shell would take it again
  int exit_code = 0;
};

// Accepts a decimal number in the range: CLI11 accepts more texts as numbers.
CLI::Validator number_in(std::pair<double, double> range);

constexpr std::int64_t largest_whole = 999'999'999'999'999'999;
// Accepts numbers in the range, written in decimal digits only: CLI11 alone reads 010 as 8 and takes what is too large
// for the largest.
CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range = {0, largest_whole});

// Refuses an empty folder name: it comes from an unset variable of a script.
CLI::Validator not_empty();

// Adds an option of which --help shows the default; one that fills a list is given once for each value.
template <class T>
CLI::Option* add_with_default(CLI::App& command, const std::string& name, T& value, const std::string& meaning) {
  CLI::Option* const option = command.add_option(name, value, meaning);
  if constexpr (std::is_same_v<T, std::vector<std::string>>)
    return option->allow_extra_args(false);
  else
    return option->capture_default_str();
}
template <class T>
CLI::Option* add_number(CLI::App& command, const std::string& name, T& value,
                        std::pair<std::int64_t, std::int64_t> range, const std::string& meaning) {
  return add_with_default(command, name, value, meaning)->check(whole_number(range));
}

// A time such as 5ms, kept in seconds.
void add_time(CLI::App& command, const std::string& name, double& seconds, const std::string& meaning);
// Adds --base and --tip, links of a URDF file.
void add_link_options(CLI::App& command, robots::UrdfChoice& urdf);

// Adds -o, the place of the output, a folder or a file.
CLI::Option* add_out_option(CLI::App& command, std::string& out, const std::string& meaning);
void add_json_option(CLI::App& command, bool& is_json);
void show_json(const base::OrderedJson& json);

// Adds --study, the name of one of a store.
void add_study_option(CLI::App& command, std::string& study);

}  // namespace ikbench::cli
