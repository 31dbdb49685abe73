// Converts a solve to a row of the store and back: the SQL columns, their values, and checks on reading.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "results/record.hpp"

namespace ikbench::results {

// A value in the file that ikbench does not write.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Text of the file for a sentence: in quotes, up to a NUL character, cut if it is long.
std::string excerpt(std::string_view text);
std::string excerpt(const SQLite::Column& column);

constexpr std::int64_t store_version = 2;

// SQL that creates the table `solves`, and SQL that reads its rows; a condition and an order may follow.
std::string create_solves();
std::string select_solves();

// An INSERT with a parameter for each column, and the binding of their values.
std::string insert_solve();
void bind_solve(SQLite::Statement& insert, const SolveRecord& record);

// Reads the present row of a statement of select_solves. Damage names the column.
SolveRecord solve_in(SQLite::Statement& row);

// A value of a column that must have its type, one of std::string, int, std::int64_t; else Damage.
template <class Value>
Value value_in(const SQLite::Column& column);

}  // namespace ikbench::results
