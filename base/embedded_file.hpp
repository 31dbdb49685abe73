// Files that the build embeds in the program (packaging/embed.cmake): arms, studies, readings, printed tables, the
// page.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace ikbench::base {

struct EmbeddedFile {
  std::string_view name;  // its path within its folder: "slim2023/table-3.csv"
  std::string_view text;

  constexpr std::string_view stem() const { return name.substr(0, name.rfind('.')); }
};

// Finds a file by its name without the extension; null if there is none.
constexpr const EmbeddedFile* find_embedded(std::span<const EmbeddedFile> files, std::string_view stem) {
  const auto found = std::ranges::find(files, stem, &EmbeddedFile::stem);
  return found == files.end() ? nullptr : &*found;
}

}  // namespace ikbench::base
