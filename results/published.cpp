// Published tables: the CSV files of results/published, which the build embeds here (embed.cmake).
#include "results/published.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "numerics/embedded_file.hpp"

namespace ikbench::results::published {

using namespace numerics;

namespace {

constexpr EmbeddedFile files[]{
#include "published_tables.inc"
};

std::string_view paper_of(const EmbeddedFile& file) { return file.name.substr(0, file.name.find('/')); }

}  // namespace

CsvTable table(std::string_view paper, std::string_view name) {
  if (const EmbeddedFile* const file = find_embedded(files, fmt::format("{}/{}", paper, name)))
    return parse_csv(file->text, std::string(file->name));
  throw std::invalid_argument(fmt::format("there is no table {} of {}", name, paper));
}

std::vector<std::string_view> papers() {
  std::vector<std::string_view> names;
  for (const EmbeddedFile& file : files)
    if (std::ranges::find(names, paper_of(file)) == names.end()) names.push_back(paper_of(file));
  return names;
}

std::vector<std::string_view> tables(std::string_view paper) {
  std::vector<std::string_view> names;
  for (const EmbeddedFile& file : files)
    if (paper_of(file) == paper) names.push_back(file.stem().substr(paper.size() + 1));
  return names;
}

}  // namespace ikbench::results::published
