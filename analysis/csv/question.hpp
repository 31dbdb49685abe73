// Asks the user for options that a table needs: shows the columns of the table, and the commands that could answer.
// layout.cpp and user_csv.cpp ask if the options leave the layout open. A question reads a million cells at most, so
// that huge tables are quick, too.
#pragma once

#include <string_view>

#include "analysis/csv/layout.hpp"

namespace ikbench::csv {

// Returns whether a column is 0, 1, 2 ... or 1, 2, 3 ... in the order of the rows, as pandas and R write row numbers.
bool is_index(const Sheet& sheet, std::size_t column);

// The columns, as far as they are known when a question has to be asked.
struct Known {
  Columns columns;  // shown
  Columns named;    // named by an option
  Columns indices;  // columns that number the rows, and that no option names
  bool is_wide = false;
  Column label;    // empty: not known
  Columns values;  // empty: not known
};

// Returns whether the rows have means and standard deviations, as --summaries reads them.
bool are_summaries(const Sheet& sheet);
// Adds the answer --summaries to a question.
void answer_by_summaries(const Sheet& sheet, MissingOption& asked, const std::vector<std::string>& better);

// Throws MissingOption, which asks for labels and values. If few answers are possible, each is a whole command;
// otherwise options that are open have a placeholder.
[[noreturn]] void ask_for_columns(const Sheet& sheet, const Request& request, const Known& known);
// Throws MissingOption, which asks what a row is.
[[noreturn]] void ask_for_rows(const Sheet& sheet, const Request& request, const Known& known);

}  // namespace ikbench::csv
