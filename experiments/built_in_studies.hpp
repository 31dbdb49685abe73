// The built-in studies as text: the files of studies/, which the build carries here (embed.cmake).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ikbench::experiments {

struct BuiltInStudy {
  std::string name;  // of the file, without .toml, and of the study
  std::string_view toml;
};

// By name.
std::vector<BuiltInStudy> built_in_studies();

}  // namespace ikbench::experiments
