// Commands and their options, in the words of CLI11. Its headers take longer to compile than all else of a command, so
// only options.cpp and main.cpp include them. Options that several commands have, and JSON as an answer.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "numerics/json_fwd.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ikbench::cli {

// Says what is wrong with the text of an option, or nothing; --help shows what is expected.
struct Check {
  std::string expected;
  std::function<std::string(const std::string&)> mistake;
};

class CommandOption {
 public:
  explicit CommandOption(CLI::Option& option) : option_(&option) {}
  CommandOption* required();
  CommandOption* check(const Check& check);
  CommandOption* capture_default_str();         // --help shows the default
  CommandOption* allow_extra_args(bool value);  // false: one value each time it is given
  CommandOption* delimiter(char mark);
  CommandOption* excludes(const CommandOption* other);

 private:
  CLI::Option* option_;
};

class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}
  Command* add_subcommand(const std::string& name, const std::string& meaning);
  // T is one of the types at the end of options.cpp.
  template <typename T>
  CommandOption* add_option(const std::string& name, T& value, const std::string& meaning);
  CommandOption* add_flag(const std::string& name, bool& value, const std::string& meaning);
  void footer(const std::string& text);
  void callback(std::function<void()> run);
  std::size_t count(const std::string& option) const;  // how often it was given

 private:
  CLI::App* app_;
  std::deque<Command> subcommands_ = {};
  std::deque<CommandOption> options_ = {};
};

// Accepts a decimal number in the range: CLI11 accepts more texts as numbers.
Check number_in(std::pair<double, double> range);

constexpr std::int64_t largest_whole = 999'999'999'999'999'999;
// Accepts numbers in the range, written in decimal digits only: CLI11 alone reads 010 as 8 and takes what is too large
// for the largest.
Check whole_number(std::pair<std::int64_t, std::int64_t> range = {0, largest_whole});

Check one_of(const std::vector<std::string>& words);

// Refuses an empty folder name: it comes from an unset variable of a script.
Check not_empty();

void add_json_option(Command& command, bool& is_json);
void show_json(const numerics::OrderedJson& json);

}  // namespace ikbench::cli
