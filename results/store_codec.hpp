// A solve as a row of the store, and back: the columns of SQL, the values in them, and what they must be when they are
// read. The file may be anybody's: whatever in it ikbench would not have written is Damage.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"

namespace ikbench::results {

// Something in the file that no store of ours has.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Text of the file within a sentence: in quotes, up to a NUL character, and not all of it where it is long.
std::string excerpt(std::string_view text);
std::string excerpt(const SQLite::Column& column);

// Each version of the schema has one column more than the one before it, which is the next of columns.inc.
constexpr std::int64_t columns_before_schema_1 = 25;
constexpr std::int64_t schema_version = [] {
  std::int64_t columns = 0;
  for_each_column([&](auto, auto, auto) { ++columns; });
  return columns - columns_before_schema_1;
}();

// SQL for the table `solves` of a version of the schema: to make it, to read rows of it, each after its rowid (a
// condition and an order may follow), and to give it the columns of this program. A column that schema 1 does not have
// has a default, so that rows without it can be read, and an older program that still has the store open can write.
std::string create_solves(std::int64_t version);
std::string select_solves(std::int64_t version);
std::vector<std::string> add_columns_after(std::int64_t version);
std::vector<std::string_view> column_names(std::int64_t version);

// An INSERT with a parameter for each column, and their values.
std::string insert_solve();
void bind_solve(SQLite::Statement& insert, const SolveRecord& record);

// The row that a statement of select_solves stands at. What its version does not have is NaN for a number, else the
// column's default. Damage names the column.
SolveRecord solve_in(SQLite::Statement& row);

// What `action` returns; Damage that it finds in a row of select_solves says which solve that is.
template <class Action>
auto at_solve(SQLite::Statement& row, Action&& action) {
  try {
    return action();
  } catch (const Damage& error) {
    const auto said = [&](const char* column) { return excerpt(row.getColumn(row.getColumnIndex(column))); };
    throw Damage(fmt::format("{}; in the solve of run {}, point {} of series {}, which session {} made", error.what(),
                             said("run"), said("point"), said("series"), said("session")));
  }
}

// A value of a column that must be of its type, of which there are std::string, int, std::int64_t; else Damage.
template <class Value>
Value value_in(const SQLite::Column& column);

}  // namespace ikbench::results
