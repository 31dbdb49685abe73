// Reads the content of a folder.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "results/files.hpp"
#include "tests/scratch_folder.hpp"

namespace ikbench {

inline std::string text_of_file(const std::filesystem::path& file) { return results::read_file(file).value_or(""); }

// Every file below, relative to the folder.
inline std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.insert(std::filesystem::relative(entry.path(), folder).string());
  }
  return files;
}

}  // namespace ikbench
