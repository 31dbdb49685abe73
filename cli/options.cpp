#include "cli/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <type_traits>

#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::cli {

Option Option::required() const { return {in_cli11->required()}; }
Option Option::separated_by_commas() const { return {in_cli11->delimiter(',')}; }
Option Option::needs(const std::string& other) const { return {in_cli11->needs(other)}; }
Option Option::excludes(const std::string& other) const { return {in_cli11->excludes(other)}; }
Option Option::one_of(const std::vector<std::string>& texts) const {
  const auto check = [texts](const std::string& text) {
    return std::ranges::find(texts, text) != texts.end() ? "" : base::unknown_name("value", text, texts);
  };
  return {in_cli11->check(CLI::Validator(check, fmt::format("{{{}}}", fmt::join(texts, ","))))};
}

Option Option::time() const {
  const auto in_seconds = [](std::string& text) {
    for (const auto& [unit, size] : {std::pair<std::string, std::string>{"us", "e-6"}, {"ms", "e-3"}, {"s", ""}}) {
      if (!text.ends_with(unit)) continue;
      const auto value = base::number_from(text.substr(0, text.size() - unit.size()) + size);
      if (!value || !(*value >= 1e-6 && *value <= 1e3)) break;
      text = fmt::format("{}", *value);
      return std::string();
    }
    return fmt::format("{} is not a time from 1us to 1000s, such as 5ms", text.substr(0, 100));
  };
  return {in_cli11->transform(CLI::Validator(in_seconds, ""))->type_name("TIME")};
}

Option Option::number_in(std::pair<double, double> range) const {
  return {in_cli11->check([range](const std::string& text) {
    const auto value = base::number_from(text);
    if (value && *value >= range.first && *value <= range.second) return std::string();
    return fmt::format("{} is not a number from {} to {}", text.substr(0, 100), range.first, range.second);
  })};
}

Option Option::whole_number(std::pair<std::int64_t, std::int64_t> range) const {
  const auto mistake = [range](const std::string& text) {
    const bool are_digits = !text.empty() && text.size() <= 18 && text.find_first_not_of("0123456789") == text.npos &&
                            (text == "0" || text[0] != '0');
    if (are_digits && std::stoll(text) >= range.first && std::stoll(text) <= range.second) return std::string();
    return fmt::format("{} is not a whole number from {} to {} (without leading zeros)", text.substr(0, 100),
                       range.first, range.second);
  };
  const std::string name = range.second < max_whole_number ? fmt::format("{} to {}", range.first, range.second) : "";
  return {in_cli11->check(mistake, name)};
}

Option Command::add(const std::string& name, OptionTarget value, const std::string& meaning) const {
  const auto add_to_cli11 = [&](auto* target) {
    using Value = std::remove_pointer_t<decltype(target)>;
    if constexpr (std::is_same_v<Value, bool>) return in_cli11->add_flag(name, *target, meaning);
    CLI::Option* const option = in_cli11->add_option(name, *target, meaning);
    if constexpr (!std::is_arithmetic_v<Value>)
      option->check([](const std::string& text) { return text.empty() ? "expected a value that is not empty" : ""; });
    if (std::is_same_v<Value, std::vector<std::string>>) return option->allow_extra_args(!name.starts_with('-'));
    return *target > Value() ? option->capture_default_str() : option;
  };
  return {std::visit(add_to_cli11, value)};
}

Option Command::option(const std::string& name) const { return {in_cli11->get_option(name)}; }
bool Command::was_given(const std::string& option) const { return in_cli11->count(option) > 0; }
void Command::footer(const std::string& text) const { in_cli11->footer(text); }
void Command::callback(const std::function<void()>& run) const { in_cli11->callback(run); }

void add_link_options(const Command& command, std::string& base, std::string& tip) {
  command.add("--base", &base, "URDF link where the arm begins; default: the root");
  command.add("--tip", &tip, "URDF link where the arm ends; default: the one after the most joints");
}

void add_out_option(const Command& command, std::string& out, const std::string& meaning) {
  command.add("-o,--out", &out, meaning);
}

void add_json_option(const Command& command, bool& is_json) {
  command.add("--json", &is_json, "print the results as JSON");
}

void show_json(const base::OrderedJson& json) { fmt::print("{}\n", base::text_of(json, 2)); }

void add_study_option(const Command& command, std::string& study, const std::string& meaning) {
  command.add("--study", &study, meaning);
}

}  // namespace ikbench::cli
