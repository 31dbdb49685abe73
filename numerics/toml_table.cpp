#include "numerics/toml_table.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "numerics/json.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"

namespace ikbench::numerics {

namespace {

std::string shown(const toml::node& node) {
  std::ostringstream out;
  out << toml::toml_formatter(node, toml::format_flags::none);
  std::string text = out.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.size() <= 80 ? text : text.substr(0, 77) + "...";
}

}  // namespace

std::string text_of_file(const std::filesystem::path& file, std::uintmax_t largest) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw std::invalid_argument(fmt::format("{} is no regular file", file.string()));
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::array<char, 1 << 16> part;
  while (in.read(part.data(), part.size()) || in.gcount() > 0) {  // the size of a file may be unknown
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest) {
      throw std::invalid_argument(
          fmt::format("{}: expected a file of at most {:g} MB", file.string(), static_cast<double>(largest) / 1e6));
    }
  }
  if (!in.is_open() || in.bad()) throw std::invalid_argument(fmt::format("cannot read {}", file.string()));
  return text;
}

void refuse_deep_keys(std::string_view text, std::string_view source) {
  constexpr int most_dots = 500;
  int line = 1, column = 0, dots = 0;
  for (const char c : text) {
    ++column;
    if (c == '\n' || c == ',') dots = 0;
    if (c == '.' && ++dots > most_dots) {
      throw std::invalid_argument(
          fmt::format("{}:{}:{}: not readable TOML: {} dots in a row; expected less deeply nested keys", source, line,
                      column, dots));
    }
    if (c == '\n') {
      ++line;
      column = 0;
    }
  }
}

toml::table parse_toml(std::string_view text, std::string_view source) {
  refuse_deep_keys(text, source);
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position& begin = error.source().begin;
    throw std::invalid_argument(
        fmt::format("{}:{}:{}: not TOML: {}", source, begin.line, begin.column, error.description()));
  }
  return table;
}

std::string toml_of(const nlohmann::json& json, int levels) {
  if (levels == 0) throw std::invalid_argument("a value that is nested too deeply");
  std::string text;
  if (json.is_array()) {
    for (const nlohmann::json& element : json) text += toml_of(element, levels - 1) + ", ";
    return fmt::format("[{}]", text);
  }
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      if (key != "name")
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", text_of(nlohmann::json(key)),
                            toml_of(value, levels - 1));
    }
    return fmt::format("{{{}}}", text);
  }
  return text_of(json);
}

void TomlReader::text(std::string_view key, std::string& field, std::string_view) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const toml::value<std::string>* value = node->as_string();
  if (value == nullptr) fail(key, *node, "a quoted string");
  if (!is_plain(value->get())) fail(key, *node, plain);
  field = value->get();
}

void TomlReader::texts(std::string_view key, std::vector<std::string>& field, std::string_view) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const std::vector<std::string> found = texts_in(*node);
  const toml::array* array = node->as_array();
  const bool are_texts = array != nullptr && !array->empty() && array->size() <= 1000 &&
                         array->is_homogeneous<std::string>() && std::ranges::all_of(found, is_plain);
  if (!are_texts) fail(key, *node, "a list of quoted strings, each of at most 200 bytes without control characters");
  field = found;
}

void TomlReader::number(std::string_view key, double& field, double unit, std::pair<double, double> range,
                        std::string_view) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const std::optional<double> value = as_number(*node);
  if (!value || !(*value >= range.first && *value <= range.second)) {
    fail_number(key, *node, fmt::format("a number from {} to {}", range.first, range.second));
  }
  field = *value * unit;
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

void TomlReader::refuse_unknown_keys() const {
  for (const auto& [key, node] : table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) == known_.end()) {
      throw std::invalid_argument(where(key.source(), key.str()) + unknown_name("key", key.str(), known_));
    }
  }
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
  if (region.begin.line == 0 || region.path) return fmt::format("--set {}{}: ", prefix_, key);
  return fmt::format("{}:{}:{}: ", source_, region.begin.line, region.begin.column);
}

bool TomlReader::is_plain(std::string_view text) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  const auto is_c1 = [](unsigned char first, unsigned char second) { return first == 0xc2 && second < 0xa0; };
  return text.size() <= 200 && std::none_of(text.begin(), text.end(), is_control) &&
         std::adjacent_find(text.begin(), text.end(), is_c1) == text.end();
}

std::vector<std::string> TomlReader::texts_in(const toml::node& node) {
  std::vector<std::string> result;
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) result.push_back(element.value<std::string>().value_or(""));
  }
  return result;
}

std::optional<double> TomlReader::as_number(const toml::node& node) {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace ikbench::numerics
