#include "solvers/options.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/names.hpp"

namespace ikbench::solvers {

using namespace base;

namespace {

template <class Number>
Option ranged(std::string name, Number& field, std::pair<Number, Number> range, std::string_view kind,
              std::string meaning) {
  return {.name = std::move(name),
          .expected = fmt::format("a {} from {} to {}", kind, range.first, range.second),
          .meaning = std::move(meaning),
          .extremes = {static_cast<double>(range.first), static_cast<double>(range.second)},
          .get = [&field] { return static_cast<double>(field); },
          .set =
              [&field, range](const Setting& value) {
                const double* const number = std::get_if<double>(&value);
                if (number == nullptr || !(*number >= range.first && *number <= range.second)) return false;
                if (static_cast<Number>(*number) != *number) return false;
                field = static_cast<Number>(*number);
                return true;
              }};
}

}  // namespace

std::string text_of(const Setting& setting) {
  const double* const number = std::get_if<double>(&setting);
  return number == nullptr ? std::get<std::string>(setting) : fmt::format("{}", *number);
}

void OptionList::number(std::string name, double& field, std::pair<double, double> range, std::string meaning) {
  add(ranged(std::move(name), field, range, "number", std::move(meaning)));
}

void OptionList::count(std::string name, int& field, std::pair<int, int> range, std::string meaning) {
  add(ranged(std::move(name), field, range, "whole number", std::move(meaning)));
}

void OptionList::add(Option option) {
  option.is_later = is_later_;
  options_.push_back(std::move(option));
}

void OptionList::set(std::string_view name, const Setting& value) {
  const Option& option = find_named("option", name, options_, [](const Option& each) { return each.name; });
  if (!option.set(value))
    throw std::invalid_argument(
        fmt::format("option {} is \"{}\"; expected {}", name, front(text_of(value), 100), option.expected));
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
