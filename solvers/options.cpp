#include "solvers/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::solvers {

using namespace base;

namespace {

// Parses the whole text as a number, in no locale.
template <class Number>
bool parse(std::string_view text, Number& value) {
  const char* end = text.data() + text.size();
  const auto [rest, error] = read_number(text.data(), end, value);
  return error == std::errc() && rest == end;
}

template <class Number>
Option ranged(std::string name, Number& field, std::pair<Number, Number> range, std::string expected,
              std::string meaning) {
  return {.name = std::move(name),
          .expected = std::move(expected),
          .meaning = std::move(meaning),
          .choices = {},
          .bounds = {fmt::format("{}", range.first), fmt::format("{}", range.second)},
          .is_later = false,
          .get = [&field] { return fmt::format("{}", field); },
          .set =
              [&field, range](std::string_view text) {
                Number value{};
                if (!parse(text, value) || !(value >= range.first && value <= range.second)) return false;
                field = value;
                return true;
              }};
}

}  // namespace

void OptionList::number(std::string name, double& field, std::pair<double, double> range, std::string meaning) {
  add(ranged(std::move(name), field, range, fmt::format("a number from {} to {}", range.first, range.second),
             std::move(meaning)));
}

void OptionList::count(std::string name, int& field, std::pair<int, int> range, std::string meaning) {
  add(ranged(std::move(name), field, range, fmt::format("a whole number from {} to {}", range.first, range.second),
             std::move(meaning)));
}

void OptionList::add_choice(std::string name, std::vector<std::string> names, std::string meaning,
                            std::function<std::string()> get, std::function<bool(std::string_view)> set) {
  std::string expected = fmt::format("one of {}", fmt::join(names, ", "));
  add({.name = std::move(name),
       .expected = std::move(expected),
       .meaning = std::move(meaning),
       .choices = std::move(names),
       .bounds = {},
       .is_later = false,
       .get = std::move(get),
       .set = std::move(set)});
}

void OptionList::add(Option option) {
  option.is_later = is_later_;
  options_.push_back(std::move(option));
}

void OptionList::set(std::string_view name, std::string_view value) {
  std::vector<std::string> names;
  for (const Option& option : options_) {
    if (option.name != name) {
      names.push_back(option.name);
      continue;
    }
    if (option.set(value)) return;
    throw std::invalid_argument(
        fmt::format("option {} is \"{}\"; expected {}", name, value.substr(0, 100), option.expected));
  }
  throw std::invalid_argument(unknown_name("option", name, names));
}

void OptionList::set(const Settings& settings) {
  for (const auto& [name, value] : settings) set(name, value);
}

Settings OptionList::values() const {
  Settings values;
  for (const Option& option : options_) values[option.name] = option.get();
  return values;
}

}  // namespace ikbench::solvers
