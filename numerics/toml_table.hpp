// Parses TOML and reads the fields of a table by name, unit and range. Every mistake is one sentence with file, line,
// column, value and what was expected.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "numerics/names.hpp"

// Include toml++ only through this file. A malformed file fails some of its assertions and is an error later anyway; it
// must not end a debug build.
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <toml++/toml.h>

namespace ikbench::numerics {

// The `path` of nodes that come from an override; nodes of a file have none.
constexpr std::string_view override_source = "--set";

// The content of a file; std::invalid_argument if it is larger than `largest` bytes or cannot be read.
std::string text_of_file(const std::filesystem::path& file, std::uintmax_t largest = 10'000'000);

// All of these throw std::invalid_argument with the place, as `source`:line:column, and the mistake.
toml::table parse_toml(std::string_view text, std::string_view source);
// Refuses keys such as a.a.a.a, tables nested in tables. toml++ bounds the depth of brackets, not of these, and a
// hundred thousand of them exhaust the stack.
void refuse_deep_keys(std::string_view text, std::string_view source);

// A value of a stored definition as one line of TOML, without names. A store is not trusted: keys and texts are quoted,
// and std::invalid_argument refuses a value that is nested deeper than `levels`.
std::string toml_of(const nlohmann::json& json, int levels = 4);

// Reads one table, and remembers which keys were read.
class TomlReader {
 public:
  TomlReader(const toml::table& table, std::string_view source, std::string prefix)
      : table_(table), source_(source), prefix_(std::move(prefix)) {}

  void text(std::string_view key, std::string& field, std::string_view);
  void texts(std::string_view key, std::vector<std::string>& field, std::string_view);

  template <class Enum>
  void choice(std::string_view key, Enum& field, const Choices<Enum>& choices, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const std::optional<std::string> wanted = node->value<std::string>();
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) {
      if (wanted == name) {
        field = value;
        return;
      }
      names.push_back(name);
    }
    fail(key, *node,
         fmt::format("one of \"{}\"{}", fmt::join(names, "\", \""), did_you_mean(wanted.value_or(""), names)));
  }

  // Reads some of the choices, at least one and none twice, in the order of the choices.
  template <class Enum>
  void chosen(std::string_view key, std::vector<Enum>& field, const Choices<Enum>& choices, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    std::vector<std::string> wanted = texts_in(*node), names;
    std::vector<Enum> found;
    for (const auto& [name, value] : choices) {
      if (std::erase(wanted, name) == 1) found.push_back(value);
      names.push_back(name);
    }
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() != found.size() || found.empty()) {
      fail(key, *node, fmt::format("a list of some of \"{}\", each once", fmt::join(names, "\", \"")));
    }
    field = std::move(found);
  }

  template <class Whole>
  void whole(std::string_view key, Whole& field, std::pair<std::int64_t, std::int64_t> range, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::value<std::int64_t>* value = node->as_integer();
    if (value == nullptr || value->get() < range.first || value->get() > range.second) {
      fail_number(key, *node, fmt::format("a whole number from {} to {}", range.first, range.second));
    }
    field = static_cast<Whole>(value->get());
  }

  void number(std::string_view key, double& field, double unit, std::pair<double, double> range, std::string_view);

  // `size` 0 allows any number of values.
  template <class Vector>
  void numbers(std::string_view key, Vector& field, double unit, int size, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    const std::string expected = size == 0 ? "a list of numbers" : fmt::format("a list of {} numbers", size);
    if (array == nullptr || (size != 0 && array->size() != static_cast<std::size_t>(size))) fail(key, *node, expected);
    field.resize(static_cast<Eigen::Index>(array->size()));
    Eigen::Index index = 0;
    for (const toml::node& element : *array) {
      const std::optional<double> value = as_number(element);
      if (!value || !(std::abs(*value) <= 1e6)) fail(key, element, expected + " within +-1e6");
      field[index++] = *value * unit;
    }
  }

  // The value of a key, which then counts as known; null if it is not given.
  const toml::node* find(std::string_view key);
  // The same for a key whose value must be a table.
  const toml::table* subtable(std::string_view key);
  // Call it after all keys were read.
  void refuse_unknown_keys() const;

  [[noreturn]] void fail(std::string_view key, const toml::node& node, std::string_view expected) const;
  // Adds ", without quotes" for a number in quotes.
  [[noreturn]] void fail_number(std::string_view key, const toml::node& node, std::string_view expected) const;
  // "study.toml:3:8: ", or "--set path.tool: " if the value is from no file.
  std::string where(const toml::source_region& region, std::string_view key) const;

  // True for a text that is safe in a message, a table or a file's name: at most 200 bytes, no control characters.
  static bool is_plain(std::string_view text);
  static constexpr std::string_view plain = "a text of at most 200 bytes without control characters";

  TomlReader nested(const toml::table& table, std::string prefix) const { return {table, source_, std::move(prefix)}; }
  const toml::table& table() const { return table_; }
  const std::string& prefix() const { return prefix_; }
  std::filesystem::path source() const { return source_; }

 private:
  static std::optional<double> as_number(const toml::node& node);    // nothing if not finite
  static std::vector<std::string> texts_in(const toml::node& node);  // empty if no list

  const toml::table& table_;
  std::string source_;
  std::string prefix_;
  std::vector<std::string> known_;
};

}  // namespace ikbench::numerics
