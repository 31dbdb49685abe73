// A solver's options, listed once: name, field, range and meaning. The field's initialiser is the default. Studies,
// --set, `ikbench list solvers` and the provenance in the store all use this list.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ikbench::solvers {

// The value of an option: a number, or the name of a choice.
using Setting = std::variant<double, std::string>;
std::string text_of(const Setting& setting);
using Settings = std::map<std::string, Setting, std::less<>>;  // by the options' names

// One option of a solver.
struct Option {
  std::string name;
  std::string expected;  // "a number from 0 to 1", "one of greedy, loudness"
  std::string meaning;
  std::vector<Setting> extremes;  // all choices, or the smallest and the largest number
  bool is_later = false;          // was added after solves had been stored
  std::function<Setting()> get;
  std::function<bool(const Setting&)> set;  // false if the value is not as expected
};

// The options of a solver, in the order in which its Options list them.
class OptionList {
 public:
  // Marks options that are listed from here on as later ones. They enter the key of a series only if they differ from
  // their defaults, so that a new option leaves stored solves as they are.
  void later() { is_later_ = true; }
  void number(std::string name, double& field, std::pair<double, double> range, std::string meaning);
  void count(std::string name, int& field, std::pair<int, int> range, std::string meaning);

  template <class Enum>
  void choice(std::string name, Enum& field, std::vector<std::pair<std::string, Enum>> values, std::string meaning) {
    using Value = std::pair<std::string, Enum>;
    Option option{.name = std::move(name), .expected = "one of ", .meaning = std::move(meaning)};
    for (const Value& value : values) {
      option.expected += (option.extremes.empty() ? "" : ", ") + value.first;
      option.extremes.emplace_back(value.first);
    }
    option.get = [&field, values] { return std::ranges::find(values, field, &Value::second)->first; };
    option.set = [&field, values](const Setting& wanted) {
      const auto found = std::ranges::find(values, text_of(wanted), &Value::first);
      if (found != values.end()) field = found->second;
      return found != values.end();
    };
    add(std::move(option));
  }

  const std::vector<Option>& options() const { return options_; }

  // Throws std::invalid_argument, which names an unknown option (and the nearest known one) or a wrong value.
  void set(std::string_view name, const Setting& value);
  void set(const Settings& settings);
  Settings values() const;

 private:
  void add(Option option);

  std::vector<Option> options_;
  bool is_later_ = false;
};

}  // namespace ikbench::solvers
