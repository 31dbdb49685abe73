#include "analysis/claims/printed.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "numerics/number.hpp"
#include "results/published.hpp"

namespace ikbench::claims {

using namespace numerics;
using namespace results;

namespace {

void add_table(SQLite::Database& database, const std::string& name, const CsvTable& table) {
  std::vector<std::string> columns, places;
  for (const std::string& column : table.header) {
    columns.push_back(fmt::format("\"{0}\" REAL, \"{0}{1}\" TEXT", column, printed_suffix));
    places.emplace_back("?, ?");
  }
  database.exec(fmt::format("CREATE TABLE \"{}\" ({})", name, fmt::join(columns, ", ")));
  for (const std::vector<std::string>& row : table.rows) {
    SQLite::Statement insert(database, fmt::format("INSERT INTO \"{}\" VALUES ({})", name, fmt::join(places, ", ")));
    for (std::size_t i = 0; i < 2 * row.size(); ++i) insert.bind(static_cast<int>(i) + 1, row[i / 2]);
    insert.exec();
  }
}

}  // namespace

double half_unit(std::string_view printed) {
  const std::size_t e = std::min(printed.find_first_of("eE"), printed.size());
  const std::size_t point = printed.find('.');
  const std::size_t decimals = point < e ? e - point - 1 : 0;
  return number_from(fmt::format("0.5e-{}", decimals)).value() *
         (e < printed.size() ? number_from(fmt::format("1{}", printed.substr(e))).value() : 1.0);
}

SQLite::Database printed_database(std::string_view paper) {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  CsvTable said{.header = {"paper"}, .rows = {{std::string(paper)}}};
  for (const std::string_view name : published::tables(paper)) {
    const CsvTable table = published::table(paper, name);
    std::string sql_name(name);
    std::ranges::replace(sql_name, '-', '_');
    add_table(database, sql_name, table);
    if (name != "statements") continue;
    for (const std::vector<std::string>& row : table.rows) {
      said.header.push_back(row[table.column("name")]);
      said.rows.front().push_back(row[table.column("value")]);
    }
  }
  add_table(database, "said", said);
  return database;
}

}  // namespace ikbench::claims
