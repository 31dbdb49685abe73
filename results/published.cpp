// Published tables: the CSV files of results/published, which the build carries here (embed.cmake).
#include "results/published.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace ikbench::results::published {
namespace {

struct Embedded {
  std::string_view file;  // "slim2023/table-3.csv"
  std::string_view csv;

  std::string_view paper() const { return file.substr(0, file.find('/')); }
  std::string_view name() const { return file.substr(paper().size() + 1, file.rfind('.') - paper().size() - 1); }
};

constexpr Embedded embedded_tables[] = {
#include "published_tables.inc"
};

}  // namespace

CsvTable table(std::string_view paper, std::string_view name) {
  for (const Embedded& embedded : embedded_tables)
    if (embedded.paper() == paper && embedded.name() == name)
      return parse_csv(embedded.csv, std::string(embedded.file));
  const auto names = tables(paper);
  if (names.empty())
    throw std::invalid_argument(
        fmt::format("no published paper '{}'; expected one of: {}", paper, fmt::join(papers(), ", ")));
  throw std::invalid_argument(
      fmt::format("no table '{}' of {}; expected one of: {}", name, paper, fmt::join(names, ", ")));
}

std::vector<std::string_view> papers() {
  std::vector<std::string_view> names;
  for (const Embedded& embedded : embedded_tables)
    if (std::find(names.begin(), names.end(), embedded.paper()) == names.end()) names.push_back(embedded.paper());
  return names;
}

std::vector<std::string_view> tables(std::string_view paper) {
  std::vector<std::string_view> names;
  for (const Embedded& embedded : embedded_tables)
    if (embedded.paper() == paper) names.push_back(embedded.name());
  return names;
}

}  // namespace ikbench::results::published
