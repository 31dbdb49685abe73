// Parses TOML and reads the fields of a table by name, unit and range. Every mistake is one sentence with file, line,
// column, value and what was expected, of which toml++ knows the place alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/fields.hpp"

// Include toml++ only through this file. A malformed file fails some of its assertions and is an error later anyway; it
// must not end a debug build.
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <toml++/toml.h>

namespace ikbench::base {

// The `path` of nodes that come from an override, or another option; nodes of a file have none.
constexpr std::string_view override_source = "--set";

// All of these throw std::invalid_argument with the place, as `source`:line:column, and the mistake.
toml::table parse_toml(std::string_view text, std::string_view source);
// Refuses keys such as a.a.a.a, tables nested in tables. toml++ bounds the depth of brackets, not of these, and a
// hundred thousand of them exhaust the stack.
void refuse_deep_keys(std::string_view text, std::string_view source);

std::string toml_string(std::string_view text);  // in quotes, with escapes

// A JSON object as a table without nulls, so that one reader reads both.
toml::table toml_of(const nlohmann::json& object);

// Reads one table: sets the fields whose keys are given, leaves the others, and remembers which keys were read.
class TomlReader : public Fields {
 public:
  TomlReader(const toml::table& table, std::string_view source, std::string prefix)
      : table_(table), source_(source), prefix_(std::move(prefix)), is_of_text_(table.source().begin.line > 0) {}

  // The value of a key, which then counts as known; null if it is not given.
  const toml::node* find(std::string_view key);
  // The same for a key whose value must be a table.
  const toml::table* subtable(std::string_view key);
  // A reader of it, which reads nothing if it is not given.
  TomlReader part(std::string_view key);
  // The same for a key that must be given, whose value must be a list of 1 to `most` tables.
  std::vector<const toml::table*> tables(std::string_view key, std::size_t most, std::string_view expected);
  // Call it after all keys were read. Of `source` alone, override_source, if it is not empty.
  void refuse_unknown_keys(std::string_view source = "") const;

  // An exception about the value of a key, or about its absence.
  std::invalid_argument mistake(std::string_view key, std::string_view message) const;

  [[noreturn]] void fail(std::string_view key, const toml::node& node, std::string_view expected) const;
  // Adds ", without quotes" for a number in quotes.
  [[noreturn]] void fail_number(std::string_view key, const toml::node& node, std::string_view expected) const;
  // "study.toml:3:8: "; "--set path.tool: " for an override, "--robot: " of an option; "study x: " for a table that was
  // no text.
  std::string where(const toml::source_region& region, std::string_view key) const;

  TomlReader nested(const toml::table& table, std::string prefix) const {
    TomlReader reader(table, source_, std::move(prefix));
    reader.is_of_text_ = is_of_text_;
    return reader;
  }
  const toml::table& table() const { return table_; }
  const std::string& prefix() const { return prefix_; }
  std::filesystem::path source() const { return source_; }

 private:
  void on_text(Name name, std::string& field) override;
  void on_texts(Name name, std::vector<std::string>& field) override;
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override;
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t> range) override;
  void on_number(Name name, double& field, double unit, std::pair<double, double> range) override;
  void on_numbers(Name name, std::vector<double>& field, double unit, int size) override;

  // Refuses angles that seem to be in another unit.
  void refuse_doubt(std::string_view key, const toml::node& node, double value, double unit) const;
  static std::optional<double> as_number(const toml::node& node);  // nothing if not finite

  const toml::table& table_;
  std::string source_;
  std::string prefix_;
  bool is_of_text_;
  std::vector<std::string> known_;
};

}  // namespace ikbench::base
