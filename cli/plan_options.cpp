#include "cli/plan_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "numerics/number.hpp"
#include "results/analysis_plan_fields.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace results;

CLI::Validator number_in(std::pair<double, double> range) {
  return CLI::Validator(
      [range](const std::string& text) {
        const auto value = number_from(text);
        return value && *value >= range.first && *value <= range.second
                   ? std::string()
                   : fmt::format("{} is not a number from {} to {}", text.substr(0, 100), range.first, range.second);
      },
      "");
}

CLI::Validator whole_number(std::pair<std::int64_t, std::int64_t> range) {
  return CLI::Validator(
      [range](const std::string& text) {
        const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
        const bool has_zeros = digits && text.size() > 1 && text[0] == '0';
        if (digits && !has_zeros && text.size() <= 18) {
          const std::int64_t value = std::stoll(text);
          if (value >= range.first && value <= range.second) return std::string();
        }
        if (has_zeros) return fmt::format("{} has a leading zero; expected a whole number", text.substr(0, 100));
        return fmt::format("{} is not a whole number from {} to {}", text.substr(0, 100), range.first, range.second);
      },
      range.second < largest_whole ? fmt::format("{} to {}", range.first, range.second) : "");
}

CLI::Option* add_margin_option(CLI::App& command, double& margin) {
  return command.add_option_function<std::string>(
      "--margin",
      [&margin](const std::string& text) {
        const bool percent = text.ends_with('%');
        const auto value = number_from(percent ? text.substr(0, text.size() - 1) : text);
        const double share = value ? *value / (percent ? 100 : 1) : -1;
        const auto [least, most] = margins_percent;
        if (!(share >= least / 100 && share <= most / 100)) {
          throw CLI::ValidationError(
              fmt::format("--margin: {} is not a share from {} % to {} %; expected for example 5% or 0.05",
                          text.substr(0, 100), least, most));
        }
        margin = share == 0 ? 0 : share;  // "-0" is 0
      },
      fmt::format("smallest relative difference that matters, for example 5% or 0.05 [{:g}%]", 100 * margin));
}

CLI::Option* add_margin_cm_option(CLI::App& command, double& margin_cm) {
  return command
      .add_option("--margin-cm", margin_cm,
                  "the same in cm, for quantities in cm; a difference within either margin does not matter")
      ->check(number_in(margins_cm))
      ->capture_default_str();
}

CLI::Option* add_significance_option(CLI::App& command, double& significance) {
  return command
      .add_option("--significance", significance, "significance level of the tests; intervals have 1 minus this level")
      ->check(number_in(significances))
      ->capture_default_str();
}

void add_plan_options(CLI::App& command, AnalysisPlan& plan) {
  std::vector<std::string> tests;
  for (const auto& [name, value] : choices_of_tests()) tests.push_back(name);
  command.add_option("--test", plan.test, fmt::format("test that decides: {} [by_design]", fmt::join(tests, ", ")))
      ->check(CLI::Validator(
          [tests](const std::string& text) {
            const bool is_known = std::ranges::find(tests, text) != tests.end();
            return is_known ? std::string()
                            : fmt::format("{} is not one of {}", text.substr(0, 100), fmt::join(tests, ", "));
          },
          ""));
  command.add_option("--control", plan.control, "group to compare the others with; default: compare every pair");
  add_significance_option(command, plan.significance);
  add_margin_option(command, plan.margin);
  add_margin_cm_option(command, plan.margin_cm);
  command
      .add_option("--quartiles", plan.quartiles, "Hyndman-Fan type of quartiles: 7 as in R and NumPy, 5 as in MATLAB")
      ->check(whole_number({1, 9}))
      ->capture_default_str();
}

}  // namespace ikbench::cli
