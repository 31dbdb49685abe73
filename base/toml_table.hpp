// Parses TOML and reads the fields of a table by name, unit and range. Every mistake is one sentence with file, line,
// column, value and what was expected; toml++ knows only the place.
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

// Include toml++ only through this file. Some of its assertions fail for malformed files, which it reports as errors
// later; they must not end a debug build.
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <toml++/toml.h>

namespace ikbench::base {

// The `path` of nodes that come from an override or another option. Nodes of a file have none.
constexpr std::string_view override_source = "--set";

// Parses a text. All functions here throw std::invalid_argument with the place, as `source`:line:column, and the
// mistake.
toml::table parse_toml(std::string_view text, std::string_view source);
// Refuses keys such as a.a.a.a, which are tables nested in tables. toml++ bounds the depth of brackets but not of keys,
// and a hundred thousand levels exhaust the stack.
void refuse_deep_keys(std::string_view text, std::string_view source);

std::string toml_string(std::string_view text);  // in quotes, with escapes

// Returns a JSON object as a table without nulls, so that one reader reads both.
toml::table toml_of(const nlohmann::json& object);

// Reads one table: sets the fields whose keys are given, keeps the others, and remembers which keys were read. Call
// refuse_unknown_keys at the end.
class TomlReader : public Fields {
 public:
  TomlReader(const toml::table& table, std::string_view source, std::string prefix)
      : table_(table), source_(source), prefix_(std::move(prefix)), is_of_text_(table.source().begin.line > 0) {}

  // Returns the value of a key, which then counts as known; null if it is not given.
  const toml::node* find(std::string_view key);
  // Returns the same for a key whose value has to be a table.
  const toml::table* subtable(std::string_view key);
  // Returns a reader of such a table. It reads nothing if the key is not given.
  TomlReader part(std::string_view key);
  // Returns the tables of a key that has to be given, and whose value has to be a list of 1 to `most` tables.
  std::vector<const toml::table*> tables(std::string_view key, std::size_t most, std::string_view expected);
  // Throws if the table has a key that was not read. If `source` is not empty, only keys from there count
  // (override_source).
  void refuse_unknown_keys(std::string_view source = "") const;

  // Returns an exception about the value of a key, or about its absence.
  std::invalid_argument mistake(std::string_view key, std::string_view message) const;

  [[noreturn]] void fail(std::string_view key, const toml::node& node, std::string_view expected) const;
  // Throws like `fail`, and adds ", without quotes" for a number in quotes.
  [[noreturn]] void fail_number(std::string_view key, const toml::node& node, std::string_view expected) const;
  // Returns the place as a message begins with it: "study.toml:3:8: "; "--set path.tool: " for an override, "--robot: "
  // for an option; "study x: " for a table that was no text.
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

  // Throws if an angle seems to be in another unit.
  void refuse_doubt(std::string_view key, const toml::node& node, double value, double unit) const;
  static std::optional<double> as_number(const toml::node& node);  // nothing if it is not finite

  const toml::table& table_;
  std::string source_;
  std::string prefix_;
  bool is_of_text_;
  std::vector<std::string> known_;
};

}  // namespace ikbench::base
