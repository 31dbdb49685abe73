// docs/data-dictionary.md describes the columns as the program does, and its tables are those of a store.
#include <SQLiteCpp/SQLiteCpp.h>

#include <sstream>

#include "results/export.hpp"
#include "results/store.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;

namespace {

// The rows, without header and rule, of the Markdown table under a heading.
std::vector<std::string> table_under(const std::string& heading) {
  std::istringstream document(text_in("docs/data-dictionary.md"));
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(document, line) && line != heading) {
  }
  while (std::getline(document, line) && !line.starts_with('#'))
    if (line.starts_with('|')) rows.push_back(line);
  REQUIRE(rows.size() > 2);
  return {rows.begin() + 2, rows.end()};
}

std::string escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

}  // namespace

TEST_CASE("the data dictionary lists every column with its type and meaning", "[docs]") {
  std::vector<std::string> expected;
  for (const ColumnInfo& column : columns())
    expected.push_back("| `" + std::string(column.name) + "` | " + std::string(column.type) + " | " +
                       escaped(column.meaning) + " |");
  CHECK(table_under("## Columns of a solve") == expected);
}

TEST_CASE("the data dictionary lists every table with its columns", "[docs]") {
  const ScratchFolder folder;
  { const Store store(folder.path / "a.ikb", Store::Mode::write); }
  const SQLite::Database sqlite((folder.path / "a.ikb").string());
  SQLite::Statement query(sqlite,
                          "SELECT '| `' || m.name || '` | ' || group_concat('`' || c.name || '`', ', ') || ' |' "
                          "FROM sqlite_master m, pragma_table_info(m.name) c "
                          "WHERE m.type = 'table' AND m.name != 'solves' GROUP BY m.name ORDER BY m.rootpage");
  const auto rows = table_under("## Tables");
  std::size_t row = 0;
  for (; query.executeStep(); ++row)
    CHECK_THAT(rows.at(row), Catch::Matchers::StartsWith(query.getColumn(0).getString()));
  CHECK_THAT(rows.at(row), Catch::Matchers::StartsWith("| `solves` | "));
  CHECK(rows.size() == row + 1);
}
