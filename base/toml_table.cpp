#include "base/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"
#include "base/units.hpp"

namespace ikbench::base {

namespace {

std::string shown(const toml::node& node) {
  std::ostringstream out;
  out << toml::toml_formatter(node, toml::format_flags::none);
  return shortened(out.str(), 80);
}

toml::array list_of(const Json& list);

template <class Add>
void add_value(const Json& json, const Add& add) {
  if (json.is_object()) add(toml_of(json));
  if (json.is_array()) add(list_of(json));
  if (json.is_string()) add(json.get<std::string>());
  if (json.is_boolean()) add(json.get<bool>());
  if (json.is_number_integer()) add(json.get<std::int64_t>());
  if (json.is_number_float()) add(json.get<double>());
}

toml::array list_of(const Json& list) {
  toml::array array;
  for (const Json& element : list) add_value(element, [&](auto value) { array.push_back(std::move(value)); });
  return array;
}

std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 1 && text.find('\n') != std::string_view::npos; --number) text.remove_prefix(text.find('\n') + 1);
  return text.substr(0, text.find('\n'));
}

// Returns what is wrong in a line that is no TOML: our own words for usual mistakes, otherwise those of toml++.
std::string toml_mistake(std::string_view line, std::string_view description) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin != std::string_view::npos && line[begin] == '<')
    return "not TOML: the line begins with '<', as in XML or URDF; expected key = value";
  std::ptrdiff_t quotes = 0;
  for (std::size_t at = 0; at < line.size() && (line[at] != '#' || quotes % 2 != 0); ++at)
    quotes += line[at] == '"' && (at == 0 || line[at - 1] != '\\');
  if (quotes % 2 != 0) return "a quote is not closed in this line; expected one more \"";
  constexpr std::string_view opening = "Error while parsing ";  // then what is parsed, which readers need not know
  const std::size_t colon = description.find(": ");
  if (description.starts_with(opening) && colon != std::string_view::npos) description.remove_prefix(colon + 2);
  return fmt::format("not TOML: {}; expected [table] or key = value", description);
}

}  // namespace

std::string toml_string(std::string_view text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

void refuse_deep_keys(std::string_view text, std::string_view source) {
  constexpr std::size_t max_dots = 500;
  for (std::size_t at = 0, line = 1, begin = 0, dots = 0; at < text.size(); ++at) {
    if (text[at] == '\n') {
      ++line;
      begin = at + 1;
    }
    if (text[at] == '\n' || text[at] == ',') dots = 0;
    if (text[at] == '.') ++dots;
    if (dots > max_dots)
      throw std::invalid_argument(fmt::format("{}:{}:{}: a key has {} dots in a row; expected less deeply nested keys",
                                              source, line, at - begin + 1, dots));
  }
}

toml::table parse_toml(std::string_view text, std::string_view source) {
  refuse_deep_keys(text, source);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position& begin = error.source().begin;
    throw std::invalid_argument(fmt::format("{}:{}:{}: {}", source, begin.line, begin.column,
                                            toml_mistake(line_of(text, begin.line), error.description())));
  }
}

toml::table toml_of(const Json& object) {
  toml::table table;
  for (const auto& member : object.items())
    add_value(member.value(), [&](auto value) { table.insert(member.key(), std::move(value)); });
  return table;
}

void TomlReader::on_text(Name name, std::string& field) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const toml::value<std::string>* value = node->as_string();
  if (value == nullptr) fail(name.key, *node, "a quoted string");
  if (!is_plain(value->get())) fail(name.key, *node, plain_text);
  field = value->get();
}

void TomlReader::on_texts(Name name, std::vector<std::string>& field) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  std::vector<std::string> found;
  const toml::array* const array = node->as_array();
  bool are_texts = array != nullptr && array->size() <= 1000;
  for (std::size_t i = 0; are_texts && i < array->size(); ++i) {
    found.push_back((*array)[i].value<std::string>().value_or("\n"));
    are_texts = is_plain(found.back());
  }
  if (!are_texts)
    fail(name.key, *node, "a list of quoted strings, each of at most 200 bytes without control characters");
  field = found;
}

void TomlReader::on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const std::string wanted = node->value_or(std::string());
  const auto found = std::ranges::find(choices, wanted);
  const std::string renamed = renaming(wanted, choices);
  if (found == choices.end())
    fail(name.key, *node,
         fmt::format("one of \"{}\"{}{}", fmt::join(choices, "\", \""), renamed.empty() ? "" : "; ",
                     renamed.empty() ? did_you_mean(wanted, choices) : renamed));
  chosen = static_cast<std::size_t>(found - choices.begin());
}

void TomlReader::on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t> range) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const toml::value<std::int64_t>* value = node->as_integer();
  if (value == nullptr || value->get() < range.first || value->get() > range.second)
    fail_number(name.key, *node, fmt::format("a whole number from {} to {}", range.first, range.second));
  field = value->get();
}

void TomlReader::on_number(Name name, double& field, double unit, std::pair<double, double> range) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const std::optional<double> value = as_number(*node);
  if (!value || !(*value >= range.first && *value <= range.second))
    fail_number(name.key, *node, fmt::format("a number from {} to {}", range.first, range.second));
  if (*value != 0 && !std::isnormal(*value * unit)) fail_number(name.key, *node, "0, or a number that is not so small");
  refuse_doubt(name.key, *node, *value, unit);
  field = *value * unit;
}

void TomlReader::on_numbers(Name name, std::vector<double>& field, double unit, int size) {
  const toml::node* node = find(name.key);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  const std::string expected = size == 0 ? "a list of numbers" : fmt::format("a list of {} numbers", size);
  if (array == nullptr || (size != 0 && array->size() != static_cast<std::size_t>(size)))
    fail(name.key, *node, expected);
  field.clear();
  for (const toml::node& element : *array) {
    const std::optional<double> value = as_number(element);
    if (!value || !(std::abs(*value) <= 1e6)) fail(name.key, element, expected + " within +-1e6");
    refuse_doubt(name.key, element, *value, unit);
    field.push_back(*value * unit);
  }
}

void TomlReader::refuse_doubt(std::string_view key, const toml::node& node, double value, double unit) const {
  const std::string_view doubt = is_of_text_ && unit == degree ? doubt_of_angle(value, unit) : "";
  if (!doubt.empty())
    throw std::invalid_argument(
        fmt::format("{}{}{} is {}, which {}", where(node.source(), key), prefix_, key, value, doubt));
}

const toml::node* TomlReader::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return table_.get(key);
}

const toml::table* TomlReader::subtable(std::string_view key) {
  const toml::node* node = find(key);
  if (node != nullptr && !node->is_table()) fail(key, *node, fmt::format("a table: [{}]", key));
  return node == nullptr ? nullptr : node->as_table();
}

TomlReader TomlReader::part(std::string_view key) {
  static const toml::table none;
  const toml::table* const table = subtable(key);
  return nested(table == nullptr ? none : *table, fmt::format("{}{}.", prefix_, key));
}

std::vector<const toml::table*> TomlReader::tables(std::string_view key, std::size_t most, std::string_view expected) {
  const toml::node* node = find(key);
  if (node == nullptr) throw mistake(key, fmt::format("{}{} is missing; expected {}", prefix_, key, expected));
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty() || array->size() > most) fail(key, *node, expected);
  std::vector<const toml::table*> found;
  for (const toml::node& element : *array) {
    if (!element.is_table()) fail(key, element, expected);
    found.push_back(element.as_table());
  }
  return found;
}

void TomlReader::refuse_unknown_keys(std::string_view source) const {
  for (const auto& [key, node] : table_) {
    if ((source.empty() || node.source().begin.line == 0 || node.source().path) &&
        std::find(known_.begin(), known_.end(), key.str()) == known_.end()) {
      throw std::invalid_argument(where(key.source(), key.str()) + unknown_name("key", key.str(), known_));
    }
  }
}

std::invalid_argument TomlReader::mistake(std::string_view key, std::string_view message) const {
  const toml::node* const node = table_.get(key);
  return std::invalid_argument(where(node == nullptr ? table_.source() : node->source(), key) + std::string(message));
}

void TomlReader::fail(std::string_view key, const toml::node& node, std::string_view expected) const {
  throw std::invalid_argument(
      fmt::format("{}{}{} is {}; expected {}", where(node.source(), key), prefix_, key, shown(node), expected));
}

void TomlReader::fail_number(std::string_view key, const toml::node& node, std::string_view expected) const {
  const bool is_in_quotes = number_from(node.value<std::string>().value_or("")).has_value();
  fail(key, node, fmt::format("{}{}", expected, is_in_quotes ? ", without quotes" : ""));
}

std::string TomlReader::where(const toml::source_region& region, std::string_view key) const {
  if (!is_of_text_) return fmt::format("{}: ", source_);
  if (region.path && *region.path != override_source) return fmt::format("{}: ", *region.path);
  if (region.begin.line == 0 || region.path) return fmt::format("{} {}{}: ", override_source, prefix_, key);
  return fmt::format("{}:{}:{}: ", source_, region.begin.line, region.begin.column);
}

std::optional<double> TomlReader::as_number(const toml::node& node) {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace ikbench::base
