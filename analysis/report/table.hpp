// A table as every part of the report makes it, as Markdown to read and as CSV to compute with (LaTeX:
// latex_table.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ikbench::report {

struct PValue {
  double value;
};

// An interval: read as "0.12 to 0.34"; in CSV its column is two, "... low" and "... high".
struct Range {
  double low;
  double high;
};

// Our number beside a printed one: read as "0.73 (printed 0.4075: 1.8 times, outside our range 0.6872 to 0.7583)"; in
// CSV its column is two, the second "... printed".
enum class Nearness { unknown, within, near, far };  // which a page shows as a colour

struct Beside {
  double ours;
  std::string printed;  // its digits
  Nearness nearness = Nearness::unknown;
  std::string words = {};  // what there is to say of it; may be empty
};

// Words about how near our number is to a printed one.
struct Graded {
  std::string words;
  Nearness nearness = Nearness::unknown;
};

// A double that is not finite, and a p-value that is not, show as "not defined" (an empty field in CSV).
// std::monostate: there is nothing to say, an empty cell.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double, PValue, Range, Beside, Graded>;

enum class Align { left, right };

struct Column {
  std::string name;
  Align align = Align::right;
};

struct Table {
  std::string name;     // stable, the file's name: "results"
  std::string caption;  // plain text, as are notes, heads and cells: the writers escape
  std::vector<Column> columns = {};
  std::vector<std::vector<Cell>> rows = {};  // each as long as columns
  std::vector<std::string> notes = {};       // what a reader must know; not in the CSV
  int number = 0;                            // in its paper; 0: it has none
};

// "Table 3: errors"
std::string numbered_caption(const Table& table);

// Columns that are empty in every row are left out of Markdown; the CSV has them all, with every digit.
std::string to_markdown(const Table& table);
std::string to_csv(const Table& table);

// A cell as it is read, and with every digit as CSV has it.
std::string readable(const Cell& cell);
std::string computable(const Cell& cell);
std::string readable_end(double of_range);
bool is_number(const Cell& cell);  // that is shown as one
// Those that are not empty in every row.
std::vector<std::size_t> columns_in_use(const Table& table);

// Heads and cells as Markdown has them, without its escapes: the first row is the head.
std::vector<std::vector<std::string>> readable_cells(const Table& table);

}  // namespace ikbench::report
