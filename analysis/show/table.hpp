// Tables as data, and the writers that turn a table into CSV, Markdown, LaTeX, HTML, JSON and the text of a screen.
// Cells and columns say what they hold, and each writer decides how a cell looks. Whoever makes a table fills `Table`
// and does not format or escape anything. The files are documented in docs/reference/report.md.
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::show {

// A number of ours with the number that a paper prints. Readers see a column with these cells as two columns.
struct PublishedNumber {
  double ours;
  std::string printed;
  std::string sign = {};  // "~" agrees, "x" does not, "?" too wide a range to say; empty: not compared
};
// A number with what stands around the number.
struct ValueCell {
  double value;
  std::string mark = {};                                         // such as "*"; empty: none
  bool is_bound = false;                                         // an upper bound of the true value
  std::optional<judge::Interval> interval = {};                  // of the value
  std::optional<double> sd = {};                                 // standard deviation
  std::optional<judge::EffectScale> relative_to_reference = {};  // a ratio or difference, a column of its own in files
  int digits = 3;                                                // significant ones
};
// The reason why a number is not known, such as "too few to compare".
struct MissingCell {
  std::string reason;
};
// The colour of a verdict on a page.
enum class Tone { neutral, good, bad };
struct VerdictCell {
  std::string text;
  Tone tone = Tone::neutral;
  std::string key = {};  // in place of `text` in files of numbers
};
// The content of a cell. Readers see numbers with three digits, and "-" for an empty cell (std::monostate), a missing
// number and NaN.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double, judge::Interval, PublishedNumber,
                          ValueCell, MissingCell, VerdictCell>;

// Returns the cell of a text, which is an empty cell for an empty text.
inline Cell text_cell(std::string text) { return text.empty() ? Cell() : Cell(std::move(text)); }

// The role of a column, by which writers format its cells.
enum class ColumnRole {
  value,        // texts and numbers
  p,            // p-values: "0.0005", "< 0.0001"
  interval,     // intervals of the numbers before; in files of numbers the columns "low", "high" and "excluded"
  machine_only  // a column that only files of numbers have
};

// The head of a column, and the rules for writing the column's cells.
struct Column {
  std::string name;
  std::string unit = {};
  ColumnRole role = ColumnRole::value;
  std::string cell_unit = {};           // beside each number that is no ratio, in place of `unit` in the head
  std::vector<double> boundaries = {};  // no number is rounded onto these (number_within of text.hpp)
};

// Returns columns of values with these names, without units.
std::vector<Column> named_columns(const std::vector<std::string>& names);

// A table for all writers.
struct Table {
  std::string name;  // of the files and the anchor; empty: the table has no files
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows = {};
  std::vector<std::string> notes = {};
  bool is_of_study = true;  // about one study, which the caption in an article names
  // The number of rows that a page shows. The page folds the other rows, and an article leaves the other rows out
  // unless this is 0.
  std::size_t visible_rows = std::numeric_limits<std::size_t>::max();
};

// Returns "0.1 to 0.8", or "above 0 to 0.8" if the interval excludes the low end. No end is rounded onto a number of
// `ends`.
std::string interval_text(const judge::Interval& interval, const std::vector<double>& ends);

// The writers escape all texts of a table for their format.

// Returns the table as CSV. An interval and a printed number take two columns. Intervals take a third column, which
// says whether the end "low" or "high" is excluded.
std::string to_csv(const Table& table);
// Returns the table for readers in Markdown.
std::string to_markdown(const Table& whole);
// Returns the table for readers in LaTeX, for the packages booktabs and graphicx.
std::string to_latex(const Table& whole);
// Returns the table for readers as an HTML element.
std::string to_html(const Table& whole);
// Returns the table for readers as lines of a screen, with the unit at each number instead of in the head.
std::string to_text(const Table& whole);
// Returns an array with an object per row. The members are the columns of the CSV, in lower case with _ for blanks.
nlohmann::ordered_json to_json(const Table& table);

}  // namespace ikbench::show
