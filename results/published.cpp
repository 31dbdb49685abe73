// The published tables: CSV files of results/published, which the build embeds here (packaging/embed.cmake).
#include "results/published.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/embedded_file.hpp"

namespace ikbench::results::published {

using namespace base;

namespace {

// The array is no constant expression, because some tables are longer than clang++ counts.
const base::EmbeddedFile files[]{
#include "published_tables.inc"
};

std::string_view paper_of(const base::EmbeddedFile& file) { return file.name.substr(0, file.name.find('/')); }

}  // namespace

base::CsvTable table(std::string_view paper, std::string_view name) {
  const base::EmbeddedFile* const file = base::find_embedded(files, fmt::format("{}/{}", paper, name));
  return file == nullptr ? base::CsvTable() : base::parse_csv(file->text, file->name);
}

std::vector<std::string_view> papers() {
  std::vector<std::string_view> names;
  for (const base::EmbeddedFile& file : files)
    if (paper_of(file) != "libraries" && std::ranges::find(names, paper_of(file)) == names.end())
      names.push_back(paper_of(file));
  return names;
}

}  // namespace ikbench::results::published
