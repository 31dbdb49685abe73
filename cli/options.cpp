#include "cli/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>

#include "numerics/json.hpp"
#include "numerics/number.hpp"

namespace ikbench::cli {

using namespace numerics;

CommandOption* CommandOption::required() {
  option_->required();
  return this;
}

CommandOption* CommandOption::check(const Check& check) {
  option_->check(
      CLI::Validator([mistake = check.mistake](const std::string& text) { return mistake(text); }, check.expected));
  return this;
}

CommandOption* CommandOption::capture_default_str() {
  option_->capture_default_str();
  return this;
}

CommandOption* CommandOption::allow_extra_args(bool value) {
  option_->allow_extra_args(value);
  return this;
}

CommandOption* CommandOption::delimiter(char mark) {
  option_->delimiter(mark);
  return this;
}

CommandOption* CommandOption::excludes(const CommandOption* other) {
  option_->excludes(other->option_);
  return this;
}

Command* Command::add_subcommand(const std::string& name, const std::string& meaning) {
  return &subcommands_.emplace_back(*app_->add_subcommand(name, meaning));
}

template <typename T>
CommandOption* Command::add_option(const std::string& name, T& value, const std::string& meaning) {
  return &options_.emplace_back(*app_->add_option(name, value, meaning));
}

CommandOption* Command::add_flag(const std::string& name, bool& value, const std::string& meaning) {
  return &options_.emplace_back(*app_->add_flag(name, value, meaning));
}

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::callback(std::function<void()> run) { app_->callback(std::move(run)); }

std::size_t Command::count(const std::string& option) const { return app_->count(option); }

Check number_in(std::pair<double, double> range) {
  return {"", [range](const std::string& text) {
            const auto value = number_from(text);
            return value && *value >= range.first && *value <= range.second
                       ? std::string()
                       : fmt::format("{} is not a number from {} to {}", text.substr(0, 100), range.first,
                                     range.second);
          }};
}

Check whole_number(std::pair<std::int64_t, std::int64_t> range) {
  return {range.second < largest_whole ? fmt::format("{} to {}", range.first, range.second) : "",
          [range](const std::string& text) {
            const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
            const bool has_zeros = digits && text.size() > 1 && text[0] == '0';
            if (digits && !has_zeros && text.size() <= 18) {
              const std::int64_t value = std::stoll(text);
              if (value >= range.first && value <= range.second) return std::string();
            }
            if (has_zeros) return fmt::format("{} has a leading zero; expected a whole number", text.substr(0, 100));
            return fmt::format("{} is not a whole number from {} to {}", text.substr(0, 100), range.first,
                               range.second);
          }};
}

Check one_of(const std::vector<std::string>& words) {
  const std::string all = fmt::format("{{{}}}", fmt::join(words, ","));
  return {all, [words, all](const std::string& text) {
            return std::ranges::find(words, text) != words.end() ? "" : fmt::format("{} not in {}", text, all);
          }};
}

Check not_empty() {
  return {"", [](const std::string& text) { return text.empty() ? "the name is empty" : ""; }};
}

void add_json_option(Command& command, bool& is_json) {
  command.add_flag("--json", is_json, "print the answer as JSON");
}

void show_json(const numerics::OrderedJson& json) { fmt::print("{}\n", numerics::text_of(json, 2)); }

template CommandOption* Command::add_option(const std::string&, std::string&, const std::string&);
template CommandOption* Command::add_option(const std::string&, std::optional<std::string>&, const std::string&);
template CommandOption* Command::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template CommandOption* Command::add_option(const std::string&, std::vector<double>&, const std::string&);
template CommandOption* Command::add_option(const std::string&, double&, const std::string&);
template CommandOption* Command::add_option(const std::string&, int&, const std::string&);
template CommandOption* Command::add_option(const std::string&, std::int64_t&, const std::string&);

}  // namespace ikbench::cli
