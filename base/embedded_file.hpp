// The files that the build embeds in the program (packaging/embed.cmake): arms, studies, interpretations of papers,
// printed tables, the page of a report.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace ikbench::base {

struct EmbeddedFile {
  std::string_view name;  // path within its folder: "slim2023/table-3.csv"
  std::string_view text;

  constexpr std::string_view stem() const { return name.substr(0, name.rfind('.')); }
};

// Returns the file with this name without the extension; null if there is none.
constexpr const EmbeddedFile* find_embedded(std::span<const EmbeddedFile> files, std::string_view stem) {
  const auto found = std::ranges::find(files, stem, &EmbeddedFile::stem);
  return found == files.end() ? nullptr : &*found;
}

}  // namespace ikbench::base
