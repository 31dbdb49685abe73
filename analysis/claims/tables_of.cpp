#include "analysis/claims/tables_of.hpp"

#include <stdexcept>

namespace ikbench::claims {

using namespace numerics;

std::vector<TomlReader> tables_of(TomlReader& file, std::string_view key) {
  const toml::node* const node = file.find(key);
  if (node == nullptr || !node->is_array_of_tables()) {
    throw std::invalid_argument(fmt::format("{0}: no {1}; expected tables [[{1}]]", file.source().string(), key));
  }
  std::vector<TomlReader> readers;
  for (const toml::node& each : *node->as_array()) {
    readers.push_back(file.nested(*each.as_table(), fmt::format("{}.", key)));
  }
  return readers;
}

void read_prose(TomlReader& reader, std::string_view key, std::string& field) {
  const toml::node* const node = reader.find(key);
  if (node == nullptr) return;
  if (!node->is_string()) reader.fail(key, *node, "a quoted string");
  field = node->as_string()->get();
}

void read_texts(TomlReader& reader, std::string_view key, std::map<std::string, std::string>& field) {
  const toml::table* const table = reader.subtable(key);
  if (table == nullptr) return;
  TomlReader texts = reader.nested(*table, fmt::format("{}.", key));
  for (const auto& [name, value] : *table) read_prose(texts, name.str(), field[std::string(name.str())]);
}

}  // namespace ikbench::claims
