// What commands are, their options, those that several have, and JSON as an answer.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CLI {  // known to options.cpp and main.cpp alone: its code, all inline, takes longer to compile than a
                 // command's
class App;
class Option;
}  // namespace CLI

namespace ikbench::cli {

// The commands. One is a line in commands.inc, in the order of --help, with its word, what it is used for and what it
// does, and a file, which defines void add_NAME(const Command&, Invocation&). It adds its options and sets its exit
// code: 0 done, 1 a user's mistake or a damaged store, 2 our mistake or the system's, 3 something is worse or never
// answers, 4 not decided, 5 solves are missing, 128 + the number of the signal that stopped it.
struct Invocation {
  std::string command;  // as typed, as a shell would take it again
  int exit_code = 0;
};

constexpr std::int64_t max_whole_number = 999'999'999'999'999'999;

// What else is to be said of an option, or of an argument without a name.
struct Option {
  Option required() const;
  Option separated_by_commas() const;
  Option needs(const std::string& other) const;
  Option excludes(const std::string& other) const;
  Option one_of(const std::vector<std::string>& texts) const;
  Option time() const;  // such as 5ms, kept in seconds
  // A decimal number in the range: CLI11 accepts more texts as numbers.
  Option number_in(std::pair<double, double> range) const;
  // In the range and written in decimal digits only: CLI11 alone reads 010 as 8 and takes what is too large for the
  // largest.
  Option whole_number(std::pair<std::int64_t, std::int64_t> range = {0, max_whole_number}) const;

  CLI::Option* in_cli11;
};

// Where the value of an option is kept; a bool is a flag.
using OptionTarget =
    std::variant<bool*, int*, std::int64_t*, double*, std::string*, std::vector<double>*, std::vector<std::string>*>;

struct Command {
  // A text may not be empty, as an unset variable of a script is. --help shows a default that is neither empty nor
  // below what can be given, 0. A named one that fills a list of texts is given once for each.
  Option add(const std::string& name, OptionTarget value, const std::string& meaning) const;
  Option option(const std::string& name) const;  // that was added
  bool was_given(const std::string& option) const;
  void footer(const std::string& text) const;  // of its --help
  void callback(const std::function<void()>& run) const;

  CLI::App* in_cli11;
};

// Adds --base and --tip, links of a URDF file.
void add_link_options(const Command& command, std::string& base, std::string& tip);
// Adds -o, the place of the output, a folder or a file.
void add_out_option(const Command& command, std::string& out, const std::string& meaning);
void add_json_option(const Command& command, bool& is_json);
void show_json(const nlohmann::ordered_json& json);
// Adds --study, the name of one of a store.
void add_study_option(const Command& command, std::string& study);

}  // namespace ikbench::cli
