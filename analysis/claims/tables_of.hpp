// Fields of files of claims and items, besides those of numerics/toml_table.hpp.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/toml_table.hpp"

namespace ikbench::claims {

// The tables [[key]] of a file; there must be one at least.
std::vector<numerics::TomlReader> tables_of(numerics::TomlReader& file, std::string_view key);
// A text of any length, in any number of lines.
void read_prose(numerics::TomlReader& reader, std::string_view key, std::string& field);
// A table of texts, by their keys.
void read_texts(numerics::TomlReader& reader, std::string_view key, std::map<std::string, std::string>& field);

}  // namespace ikbench::claims
