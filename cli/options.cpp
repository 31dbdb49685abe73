#include "cli/options.hpp"

#include <fmt/format.h>

#include <cstring>

#include "base/number.hpp"

namespace ikbench::cli {

CLI::Validator number_in(std::pair<double, double> range) {
  const auto mistake = [range](const std::string& text) {
    const auto value = base::number_from(text);
    return value && *value >= range.first && *value <= range.second
               ? std::string()
               : fmt::format("{} is not a number from {} to {}", text.substr(0, 100), range.first, range.second);
  };
  return {mistake, ""};
}

CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range) {
  const auto mistake = [range](const std::string& text) {
    const bool are_digits = !text.empty() && text.size() <= 18 && text.find_first_not_of("0123456789") == text.npos &&
                            (text == "0" || text[0] != '0');
    if (are_digits && std::stoll(text) >= range.first && std::stoll(text) <= range.second) return std::string();
    return fmt::format("{} is not a whole number from {} to {}, without zeros before it", text.substr(0, 100),
                       range.first, range.second);
  };
  return {mistake, range.second < largest_whole ? fmt::format("{} to {}", range.first, range.second) : ""};
}

CLI::Validator not_empty() {
  return {[](const std::string& text) { return text.empty() ? "it is empty" : ""; }, ""};
}

void add_time(CLI::App& command, const std::string& name, double& seconds, const std::string& meaning) {
  command.add_option(name, seconds, meaning)
      ->transform(CLI::Validator(
          [](std::string& text) {
            for (const auto& [unit, size] : {std::pair{"us", "e-6"}, {"ms", "e-3"}, {"s", ""}}) {
              if (!text.ends_with(unit)) continue;
              const auto value = base::number_from(text.substr(0, text.size() - std::strlen(unit)) + size);
              if (!value || !(*value >= 1e-6 && *value <= 1e3)) break;
              text = fmt::format("{}", *value);
              return std::string();
            }
            return fmt::format("{} is no time from 1us to 1000s, such as 5ms", text.substr(0, 100));
          },
          ""));
}

void add_link_options(CLI::App& command, robots::UrdfChoice& urdf) {
  command.add_option("--base", urdf.base, "link of a URDF file where the arm begins; default: the root");
  command.add_option("--tip", urdf.tip, "link of a URDF file where it ends; default: behind the most joints");
}

CLI::Option* add_out_option(CLI::App& command, std::string& out, const std::string& meaning) {
  return add_with_default(command, "-o,--out", out, meaning)->check(not_empty());
}

void add_json_option(CLI::App& command, bool& is_json) {
  command.add_flag("--json", is_json, "print the answer as JSON");
}

void show_json(const base::OrderedJson& json) { fmt::print("{}\n", base::text_of(json, 2)); }

void add_study_option(CLI::App& command, std::string& study) {
  command.add_option("--study", study, "name of the study; default: the first in the store");
}

}  // namespace ikbench::cli
