#include "cli/commands.hpp"

#include <fmt/core.h>

#include <string>

#include "numerics/number.hpp"

namespace ikbench::cli {

using namespace numerics;

CLI::Validator number_in(std::pair<double, double> range) {
  const auto mistake = [range](const std::string& text) {
    const auto value = number_from(text);
    return value && *value >= range.first && *value <= range.second
               ? std::string()
               : fmt::format("{} is not a number from {} to {}", text.substr(0, 100), range.first, range.second);
  };
  return {mistake, ""};
}

CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range) {
  const auto mistake = [range](const std::string& text) {
    const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    const bool has_zeros = digits && text.size() > 1 && text[0] == '0';
    if (digits && !has_zeros && text.size() <= 18) {
      const std::int64_t value = std::stoll(text);
      if (value >= range.first && value <= range.second) return std::string();
    }
    if (has_zeros) return fmt::format("{} has a leading zero; expected a whole number", text.substr(0, 100));
    return fmt::format("{} is not a whole number from {} to {}", text.substr(0, 100), range.first, range.second);
  };
  return {mistake, range.second < largest_whole ? fmt::format("{} to {}", range.first, range.second) : ""};
}

CLI::Validator not_empty() {
  return {[](const std::string& text) { return text.empty() ? "the name is empty" : ""; }, ""};
}

void add_json_option(CLI::App& command, bool& is_json) {
  command.add_flag("--json", is_json, "print the answer as JSON");
}

void show_json(const numerics::OrderedJson& json) { fmt::print("{}\n", numerics::text_of(json, 2)); }

}  // namespace ikbench::cli
