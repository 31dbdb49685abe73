// Scripts that the user has edited: the next report keeps them and draws with them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ikbench::figures {

// The script below a line that holds its digest, so that an edit shows.
std::string with_digest(std::string_view script);

// The script that is there, if it is not what with_digest() wrote. A link is none: it may lead anywhere.
std::optional<std::string> edited_script(const std::filesystem::path& file);

}  // namespace ikbench::figures
