// Converts a solve to a row of the store and back: the SQL columns and their values. Only the store and its merge use
// it.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"

namespace ikbench::results {

// The error for a value in the file that ikbench does not write. The message says what was found.
struct CorruptValue : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr std::int64_t store_version = 4;

// Returns the names of the columns, or these with their SQL types, separated by commas.
std::string solve_columns();
std::string solve_declarations();

// Returns a list of numbers as JSON, and the numbers of such a text. Throws CorruptValue for another text.
std::string text_of_list(const std::vector<double>& numbers);
std::vector<double> list_in_text(std::string_view text);

// Adds solves to a store by one statement, which is prepared once.
class SolveInsert {
 public:
  explicit SolveInsert(SQLite::Database& store);
  void operator()(const SolveRecord& record);

 private:
  SQLite::Statement insert_;
  std::vector<std::string> lists_;  // per column, the text of a list of numbers
};

// Reads the current row of a statement that selects solve_columns(). Throws Damage, which names the column.
void read_solve(SQLite::Statement& row, SolveRecord& record);

}  // namespace ikbench::results
