// What a question tells of a table's columns, and the commands that answer it.
#pragma once

#include <string_view>

#include "analysis/csv/layout.hpp"

namespace ikbench::csv {

// A column that is 0, 1, 2 ... or 1, 2, 3 ... in the order of the rows, as pandas and R write it.
bool is_index(const Sheet& sheet, std::size_t column);

// The columns, as far as they are known when a question has to be asked.
struct Known {
  Columns columns;  // which are told
  Columns named;    // by an option
  Columns indices;  // which nobody named
  bool is_wide = false;
  Column label;    // where it is known
  Columns values;  // the same
};

// Whether the rows have means and standard deviations, as --summaries reads them; the answer that says so.
bool are_summaries(const Sheet& sheet);
void answer_by_summaries(const Sheet& sheet, MissingOption& asked, const std::vector<std::string>& better);

// Throws the Question. Where few answers are possible, each is a whole command; else what is open has a placeholder.
[[noreturn]] void ask_for_columns(const Sheet& sheet, const Request& request, const Known& known);
// Throws the Question what a row is.
[[noreturn]] void ask_for_rows(const Sheet& sheet, const Request& request, const Known& known);

}  // namespace ikbench::csv
