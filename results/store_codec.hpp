// Converts a solve to a row of the store and back: the SQL columns and their values.
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

constexpr std::int64_t store_version = 2;

// The names of the columns, and of those columns with their SQL types, separated by commas.
std::string solve_columns();
std::string solve_declarations();

// An INSERT with a parameter for each column, and the binding of their values.
std::string insert_solve();
void bind_solve(SQLite::Statement& insert, const SolveRecord& record);

// Reads the present row of a statement that selects solve_columns(). Damage names the column.
void read_solve(SQLite::Statement& row, SolveRecord& record);

}  // namespace ikbench::results
