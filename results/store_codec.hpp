// Converts a solve to a row of the store and back: the SQL columns, their values, and checks on reading. The file is
// not trusted: whatever ikbench would not have written is Damage.
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

// Text of the file for a sentence: in quotes, up to a NUL character, cut if it is long.
std::string excerpt(std::string_view text);
std::string excerpt(const SQLite::Column& column);

// Schema 1 had 26 columns. Each further column is a further version.
constexpr int columns_of_schema_1 = 26;
constexpr std::int64_t schema_version = [] {
  std::int64_t columns = 0;
  for_each_column([&](auto, auto, auto) { ++columns; });
  return columns - columns_of_schema_1 + 1;
}();

// SQL that creates the table `solves`, and SQL that reads its rows, each after its rowid; a condition and an order may
// follow.
std::string create_solves();
std::string select_solves();

// An INSERT with a parameter for each column, and the binding of their values.
std::string insert_solve();
void bind_solve(SQLite::Statement& insert, const SolveRecord& record);

// Reads the present row of a statement of select_solves. Damage names the column.
SolveRecord solve_in(SQLite::Statement& row);

// Calls `action` and returns its result; Damage in a row of select_solves names the solve.
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

// A value of a column that must have its type, one of std::string, int, std::int64_t; else Damage.
template <class Value>
Value value_in(const SQLite::Column& column);

}  // namespace ikbench::results
