#include "experiments/built_in_studies.hpp"

#include <algorithm>
#include <utility>

namespace ikbench::experiments {

namespace {

constexpr std::pair<std::string_view, std::string_view> files[]{
#include "studies.inc"
};

}  // namespace

std::vector<BuiltInStudy> built_in_studies() {
  std::vector<BuiltInStudy> studies;
  for (const auto& [file, text] : files) studies.push_back({std::string(file.substr(0, file.rfind('.'))), text});
  std::ranges::sort(studies, {}, &BuiltInStudy::name);
  return studies;
}

}  // namespace ikbench::experiments
