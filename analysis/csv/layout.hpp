// Finds the columns of label, values, blocks and runs in a user's table by the user's options. Nothing is guessed from
// names, texts or numbers, except that a column that numbers the rows has no values. docs/your-own-csv.md documents the
// options.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/sheet.hpp"

namespace ikbench::csv {

using base::Sheet, base::in_quotes;
using Column = std::optional<std::size_t>;
using Columns = std::vector<std::size_t>;
inline bool has(const Columns& columns, std::size_t column) { return std::ranges::count(columns, column) > 0; }

// The user's options, which name columns by their titles. If a file has no column `row`, that name means the number of
// each row.
struct Request {
  std::vector<std::string> values = {};  // quantities; if the label is `columns`, groups
  std::vector<std::string> label = {};   // columns that name the groups; `columns`: each column of values is a group
  std::vector<std::string> block = {};   // target or problem that all groups had, which makes values paired
  std::string run = {};                  // rows of a run (of a block) are averaged; `row`: each row is a run
  std::vector<std::string> where = {};   // "metric=error": takes only these rows
  std::vector<std::string> better = {};  // "smaller" or "larger"; for one column "quality=larger"
  std::string missing = {};              // rows without a value: "drop" or "worst"; empty: the user is asked
  bool are_means = false;                // the plan compares means, which cannot count rows without an answer
  char decimal = 0;                      // decimal mark; 0: found from the file
  bool are_summaries = false;            // rows have printed means and standard deviations
  int n = 0;                             // values of each printed mean; 0: a column says so
};

// The columns of a table. Without a label each column of values is a group.
struct Layout {
  Column label, block, run;  // run is empty if each row is a run
  Columns values, unused;
};

// The exception for a missing option, with a sentence in what(). `columns` describes the columns of the file as a
// table, `answers` has the options of each possible answer, `options` those to add if not all answers are listed, with
// placeholders in capitals, and `advice` says what the options mean.
struct MissingOption : std::invalid_argument {
  explicit MissingOption(const std::string& what) : invalid_argument(what) {}
  std::vector<std::vector<std::string>> columns = {};
  std::vector<std::string> options = {};
  std::vector<std::vector<std::string>> answers = {};
  std::string advice = {};
};

// The columns of printed means, by the titles of ikbench, pandas, hyperfine or pytest-benchmark.
struct SummaryColumns {
  Column n, mean, sd;
};
SummaryColumns summary_columns_of(const Sheet& sheet);

// Removes the rows that the request does not want, and returns the columns. A column of texts and one of numbers are
// label and values, if no other columns are left. One column of numbers beside a label has the values. If a column
// stays unnamed, the user has to say what a row is. A column that numbers the rows is not used, unless an option names
// the column, or no other column has numbers. Throws MissingOption, or std::invalid_argument as Sheet does.
Layout layout_of(Sheet& sheet, const Request& request);

}  // namespace ikbench::csv
