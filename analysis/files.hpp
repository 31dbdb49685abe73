// Files that are either whole or not there: written beside their place under another name, then renamed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ikbench {

// Creates the folder where missing. std::invalid_argument names the file and the system's reason.
void write_file(const std::filesystem::path& file, std::string_view text);
// Nothing where it cannot be read.
std::optional<std::string> read_file(const std::filesystem::path& file);

}  // namespace ikbench
