// Commands and their options, without CLI11's code. Each command's file uses this header; add_... functions for options
// that several commands have are here, too.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CLI {  // only options.cpp and main.cpp include CLI11, whose inline code takes longer to compile
                 // than a command's
class App;
class Option;
}  // namespace CLI

namespace ikbench::cli {

// One start of the program. A command is a line in commands.inc, in the order of --help, and a file. The file defines
// void add_NAME(const Command&, Invocation&), which adds the command's options and a callback. The callback sets
// `exit_code`:
// 0: done
// 1: a user's mistake, or a damaged store
// 2: an internal error, or an error of the system
// 3: something is worse, or a solver never answers
// 4: something is inconclusive
// 5: solves are missing
// 128 + the number of a signal: stopped by the signal
struct Invocation {
  std::string command;  // as typed, quoted for a shell
  int exit_code = 0;
};

constexpr std::int64_t max_whole_number = 999'999'999'999'999'999;

// An option, or an argument without a name, that was added to a command. Each function restricts the option's value,
// and returns the option, so that calls can be chained.
struct Option {
  Option required() const;
  Option separated_by_commas() const;
  Option needs(const std::string& other) const;
  Option excludes(const std::string& other) const;
  Option one_of(const std::vector<std::string>& texts) const;
  Option time() const;  // such as 5ms, stored in seconds
  // Accepts decimal numbers in the range. CLI11 would accept more texts as numbers.
  Option number_in(std::pair<double, double> range) const;
  // Accepts whole numbers in the range, written in decimal digits. CLI11 would read 010 as 8, and a number that is too
  // large as the largest.
  Option whole_number(std::pair<std::int64_t, std::int64_t> range = {0, max_whole_number}) const;

  CLI::Option* in_cli11;
};

// The variable that gets the value of an option; a bool is a flag.
using OptionTarget =
    std::variant<bool*, int*, std::int64_t*, double*, std::string*, std::vector<double>*, std::vector<std::string>*>;

// A command of the program, to which the command's file adds options.
struct Command {
  // Adds an option (a name with dashes) or an argument. An empty text is refused, because the text is often an unset
  // variable of a script. --help shows the default if the default is a number above 0, or a text that is not empty. An
  // option with a list of texts is given once for each text.
  Option add(const std::string& name, OptionTarget value, const std::string& meaning) const;
  Option option(const std::string& name) const;  // must have been added
  bool was_given(const std::string& option) const;
  void footer(const std::string& text) const;  // below the options of --help
  void callback(const std::function<void()>& run) const;

  CLI::App* in_cli11;
};

// Adds --base and --tip, links of a URDF file.
void add_link_options(const Command& command, std::string& base, std::string& tip);
// Adds -o and --out, the folder or file of the output.
void add_out_option(const Command& command, std::string& out, const std::string& meaning);
// Adds --json.
void add_json_option(const Command& command, bool& is_json);
// Prints JSON on standard output.
void show_json(const nlohmann::ordered_json& json);
// Adds --study, the name of a study in a store.
void add_study_option(const Command& command, std::string& study,
                      const std::string& meaning = "name of the study; default: the first in the store");

}  // namespace ikbench::cli
