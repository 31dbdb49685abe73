// What files of claims and items have beside the fields of numerics/toml_table.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "numerics/toml_table.hpp"

namespace ikbench::claims {

// The tables [[key]] of a file, of which there is one at least.
inline std::vector<numerics::TomlReader> tables_of(numerics::TomlReader& file, std::string_view key) {
  const toml::node* const node = file.find(key);
  if (node == nullptr || !node->is_array_of_tables()) {
    throw std::invalid_argument(fmt::format("{0}: no {1}; expected tables [[{1}]]", file.source().string(), key));
  }
  std::vector<numerics::TomlReader> readers;
  for (const toml::node& each : *node->as_array()) {
    readers.push_back(file.nested(*each.as_table(), fmt::format("{}.", key)));
  }
  return readers;
}

// A text of any length, in any number of lines.
inline void read_prose(numerics::TomlReader& reader, std::string_view key, std::string& field) {
  const toml::node* const node = reader.find(key);
  if (node == nullptr) return;
  if (!node->is_string()) reader.fail(key, *node, "a quoted string");
  field = node->as_string()->get();
}

}  // namespace ikbench::claims
