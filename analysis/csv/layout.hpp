// Which column of a user's table is what: as the user says. Nothing is guessed from names, texts or numbers, but that a
// column which numbers the rows is no value.
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

// Columns by name. A file without a column `row` has one, of the number of each row.
struct Request {
  std::vector<std::string> values = {};  // each a quantity; or groups, where the label is `columns`
  std::vector<std::string> label = {};   // who is compared; `columns`: each column of values
  std::vector<std::string> block = {};   // target or problem that all groups had: makes observations paired
  std::string run = {};                  // rows of a run (of a block) are averaged; `row`: each row is one
  std::vector<std::string> where = {};   // "metric=error": takes these rows alone
  std::vector<std::string> better = {};  // "smaller" or "larger", of one column "quality=larger"
  std::string missing = {};              // what rows without a value are: "drop", "worst"; empty: it is asked
  bool are_means = false;                // are compared, which cannot count what has no answer
  char decimal = 0;                      // mark of decimals; 0: found
  bool are_summaries = false;            // rows have printed means and standard deviations
  int n = 0;                             // values of each printed mean, where no column says it
};

// Where things are. Without a label each column of values is a group.
struct Layout {
  Column label, block, run;  // a run has several rows
  Columns values, unused;
};

// Something was not said: a sentence, the columns of the file as a table, the options of each possible answer, the
// options to add where not all answers are listed, with what is open in capitals, and what the options mean.
struct MissingOption : std::invalid_argument {
  explicit MissingOption(const std::string& what) : invalid_argument(what) {}
  std::vector<std::vector<std::string>> columns = {};
  std::vector<std::string> options = {};
  std::vector<std::vector<std::string>> answers = {};
  std::string advice = {};
};

// The columns of printed means: as ikbench, pandas, hyperfine or pytest-benchmark call them.
struct SummaryColumns {
  Column n, mean, sd;
};
SummaryColumns summary_columns_of(const Sheet& sheet);

// Takes the rows that the request wants. A column of texts and one of numbers are label and values, if no others are
// left; so is one column of numbers beside a label. Where a column stays unnamed, it has to be said what a row is. A
// column that numbers the rows is not used, unless it is named or the only one of numbers.
// Throws a Question, or std::invalid_argument as Sheet does.
Layout layout_of(Sheet& sheet, const Request& request);

}  // namespace ikbench::csv
