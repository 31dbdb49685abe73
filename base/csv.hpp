// Comma-separated values by RFC 4180: cells are quoted if needed, quotes are doubled, and any text stays as it is when
// it is written and read. One exception: a text that begins as a formula, and is no number, gets a ' before it, as
// spreadsheets write texts. Lines may end in LF or CRLF; the writer uses LF. A byte-order mark and empty lines are
// skipped. `base/sheet.hpp` reads tables that users hand in. The parser is our own, since libcsv copies every cell and
// has no line numbers for messages.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::base {

constexpr std::size_t max_csv_bytes = std::size_t{1} << 28;
constexpr std::size_t max_csv_columns = 10'000;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// The form of a table.
struct CsvForm {
  char separator = ',';        // ' ': cells are separated by any number of blanks
  std::size_t first_line = 1;  // number of the text's first line in its file
  bool has_header = true;      // false: columns are named "1", "2" ...
  bool is_ours = true;         // false: rules and comments may follow the header
  std::size_t max_bytes = max_csv_bytes;
};

// A table in memory, also with millions of rows. Cells are views of the text, which has to outlive the table. Quoted
// cells are kept without their quotes.
class CsvTable {
 public:
  std::vector<std::string> header;

  std::size_t rows() const { return lines_.size(); }
  // Returns the index of a column. Throws std::invalid_argument, which names the column and the existing ones.
  std::size_t column(std::string_view name) const;
  std::string_view cell(std::size_t row, std::size_t column) const { return cells_[row * header.size() + column]; }
  // Returns the cell as a number, nan and inf in any case included. Throws std::invalid_argument, which names row,
  // column and text.
  double number(std::size_t row, std::string_view column_name) const;
  std::size_t line(std::size_t row) const { return lines_[row]; }  // line where the row begins, from 1

 private:
  friend CsvTable parse_csv(std::string_view text, std::string_view source, const CsvForm& form);

  std::vector<std::string_view> cells_;  // row by row
  std::vector<std::size_t> lines_;
  std::vector<std::unique_ptr<const std::string>> unquoted_;
};

// Throws std::invalid_argument if the text has a byte that is not UTF-8, or a NUL byte.
void expect_text(std::string_view text, std::string_view source);
// Reads a whole stream. Stops early at a byte that is no text, and at a length that no reader takes, because a stream
// may have no end. Throws as refuse_place (base/files.hpp) if a part cannot be read.
std::string csv_text(std::istream& stream, const std::string& source);
// Reads a table. `source` is the name of the text in messages ("data.csv"). Throws std::invalid_argument with
// source:line if the text is malformed.
CsvTable parse_csv(std::string_view text, std::string_view source, const CsvForm& form = {});

// Returns true if the text begins with the mark of a comment.
bool is_comment(std::string_view text);
// Returns true for a rule in or around a table, "---+---" or "|--:|". One or two dashes are a missing value.
bool is_rule(std::string_view text);

// Append a cell, or one line of CSV, to `text`.
void append_csv_cell(std::string& text, std::string_view cell);
void append_csv_row(std::string& text, const std::vector<std::string>& cells);

}  // namespace ikbench::base
