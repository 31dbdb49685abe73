// Comma-separated values by RFC 4180: cells are quoted if needed, quotes doubled, and any text round-trips; but one
// that begins as a formula, and is no number, gets a ' before it, as spreadsheets write texts. Lines may end in LF or
// CRLF; the writer uses LF. A byte-order mark and empty lines are skipped. By hand, since libcsv copies every cell and
// knows no lines for messages.
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

struct CsvForm {
  char separator = ',';        // ' ': any number of blanks
  std::size_t first_line = 1;  // number of the text's first line in its file
  bool has_header = true;      // else columns are named "1", "2" ...
  bool is_ours = true;         // else rules and comments may stand below the header
};

// Also of millions of rows: cells are views of the text, which must outlive the table. Quoted cells are kept without
// their quotes.
class CsvTable {
 public:
  std::vector<std::string> header;

  std::size_t rows() const { return lines_.size(); }
  // Index of a column; std::invalid_argument names the column and the existing ones.
  std::size_t column(std::string_view name) const;
  std::string_view cell(std::size_t row, std::size_t column) const { return cells_[row * header.size() + column]; }
  // The cell as a number (nan and inf in any case included); std::invalid_argument names row, column and the text.
  double number(std::size_t row, std::string_view column_name) const;
  std::size_t line(std::size_t row) const { return lines_[row]; }  // where it begins, from 1

 private:
  friend CsvTable parse_csv(std::string_view text, std::string_view source, const CsvForm& form);

  std::vector<std::string_view> cells_;  // row by row
  std::vector<std::size_t> lines_;
  std::vector<std::unique_ptr<const std::string>> unquoted_;
};

// Refuses what is no UTF-8, and a NUL byte.
void expect_text(std::string_view text, std::string_view source);
// Reads the whole text, as far as it is one and not longer than the readers below take: a stream may have no end.
// Throws as refuse_place (base/files.hpp) where a part cannot be read.
std::string csv_text(std::istream& stream, const std::string& source);
// `source` is the text's name in messages ("data.csv"). Malformed text throws
// std::invalid_argument with source:line.
CsvTable parse_csv(std::string_view text, std::string_view source, const CsvForm& form = {});

// Begins with the mark of a comment.
bool is_comment(std::string_view text);
// "---+---" or "|--:|", as in and around tables; a dash or two are a missing value.
bool is_rule(std::string_view text);

// Appends a cell, or one line of CSV, to `text`.
void append_csv_cell(std::string& text, std::string_view cell);
void append_csv_row(std::string& text, const std::vector<std::string>& cells);

}  // namespace ikbench::base
