// Scripts that the user has edited: the next report keeps them and draws with them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ikbench::figures {

// Puts a line with the script's digest above it, so that an edit shows.
std::string with_digest(std::string_view script);

// The script in the file, if it is not as with_digest() wrote it. Ignores links, which may lead anywhere.
std::optional<std::string> edited_script(const std::filesystem::path& file);

}  // namespace ikbench::figures
