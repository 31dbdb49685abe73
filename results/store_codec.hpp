// Converts a solve to a row of the store and back: the SQL columns and their values.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"

namespace ikbench::results {

// A value in the file that ikbench does not write.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr std::int64_t store_version = 3;

// The names of the columns, and of those columns with their SQL types, separated by commas.
std::string solve_columns();
std::string solve_declarations();

// Adds solves to a store, prepared once for all.
class SolveInsert {
 public:
  explicit SolveInsert(SQLite::Database& store);
  void operator()(const SolveRecord& record);

 private:
  SQLite::Statement insert_;
  std::vector<std::string> lists_;  // the texts of lists of numbers, a place for each column
};

// Reads the present row of a statement that selects solve_columns(). Damage names the column.
void read_solve(SQLite::Statement& row, SolveRecord& record);

}  // namespace ikbench::results
