// The table that all parts of a report use; writes Markdown to read, CSV to compute with, and LaTeX.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::report {

struct PValue {
  double value;
};

// An interval, shown as "0.12 to 0.34"; two columns in CSV: "... low" and "... high". Without ends it is an empty cell.
struct Range {
  double low = statistics::not_defined;
  double high = statistics::not_defined;
};

Range range_of(const statistics::Estimate& of);  // without ends unless both are finite

// Our number beside a printed one, shown as "0.73 (printed 0.4075)"; two columns in CSV, the second "... printed".
enum class Nearness { unknown, within, far };  // a page shows it as a colour

struct OursAndPrinted {
  double ours;
  std::string printed;  // its digits
  Nearness nearness = Nearness::unknown;
};

// An id: of a metric (its column), or another. Readers see its name: "position error [cm]" for position_error_cm.
struct Id {
  std::string id;
};

// A double or p-value that is not finite shows as "not defined" (an empty field in CSV). std::monostate is an empty
// cell.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double, PValue, Range, OursAndPrinted, Id>;

// An empty cell if the number is not defined or infinite.
Cell or_nothing(double value);
Cell or_nothing(PValue p);

struct Table {
  std::string name;     // stable; also the file's name: "results"
  std::string caption;  // plain text, like notes, heads and cells: the writers escape
  std::vector<std::string> columns = {};
  std::vector<std::vector<Cell>> rows = {};  // each as long as columns
  std::vector<std::string> notes = {};       // remarks for the reader; not in the CSV
  std::string legend = {};                   // what the colours of a page mean
  int number = 0;                            // number in its paper; 0: none
  std::vector<std::string> times = {};       // columns of times [s], besides those of a metric of times
};

// "Table 3: errors"
std::string numbered_caption(const Table& table);

// The table as people read it. Columns and ids have names; times are in milliseconds if all of the table are below
// 0.1 s. Times are the columns of Table::times and of metrics of times, and rows with the id of such a metric. Every
// writer but CSV begins with it.
Table for_people(Table table);

// Columns that are empty in every row are left out of Markdown; the CSV has them all, with every digit.
std::string to_markdown(const Table& table);
std::string to_csv(const Table& table);

// A cell's text for reading, and for CSV with every digit.
std::string readable(const Cell& cell);
std::string computable(const Cell& cell);
std::string readable_end(double of_range);
bool is_empty(const Cell& cell);
bool is_number(const Cell& cell);                      // true if it is shown as a number
bool is_left(const Table& table, std::size_t column);  // true for a column of texts; numbers stand at the right
// Indices of columns that are not empty in every row.
std::vector<std::size_t> columns_in_use(const Table& table);

// The table with these columns only, in this order; those that it lacks are left out.
Table with_columns(const Table& table, std::span<const std::string_view> names);

// Heads and cells as in Markdown, without its escapes; the first row is the head.
std::vector<std::vector<std::string>> readable_cells(const Table& table);

// LaTeX with the rules of booktabs, scaled to its column by adjustbox where it is wider. The first line lists the
// packages it needs. Columns that are empty in every row are left out.
std::string to_latex(const Table& table);

}  // namespace ikbench::report
