// Comma-separated values by RFC 4180: cells are quoted if needed, quotes doubled, and any text round-trips; but one
// that begins as a formula, and is no number, gets a ' before it, as spreadsheets write texts. Lines may end in LF or
// CRLF; the writer uses LF. A byte-order mark and empty lines are skipped.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::results {

constexpr std::size_t max_csv_bytes = std::size_t{1} << 30;
constexpr std::size_t max_csv_columns = 10'000;

// Also of millions of rows: cells are views of the text, which must outlive them, and take 4 bytes more each. Quoted
// cells are kept without their quotes. Another separator may take the comma's place.
class CsvTable {
 public:
  std::vector<std::string> header;

  explicit CsvTable(std::string_view text = {}, char separator = ',') : text_(text), ends_{separator, '\r', '\n'} {}
  std::size_t rows() const { return header.empty() ? 0 : places_.size() / header.size(); }
  // Index of a column; std::invalid_argument names the column and the existing ones.
  std::size_t column(std::string_view name) const;
  std::string_view cell(std::size_t row, std::size_t column) const;
  // The cell as a number (nan and inf in any case included); std::invalid_argument names row, column and the text.
  double number(std::size_t row, std::string_view column_name) const;
  std::size_t line(std::size_t row) const { return lines_[row]; }  // where it begins, from 1
  void begin_row(std::size_t line) { lines_.push_back(static_cast<std::uint32_t>(line)); }
  void append_plain(std::string_view cell);  // a part of the text, before a comma, a line's end or the text's end
  void append_unquoted(std::string cell);

 private:
  std::string_view text_;
  std::array<char, 3> ends_;           // of a cell
  std::vector<std::uint32_t> places_;  // by row: a cell's begin, or beyond the text: place in unquoted_
  std::vector<std::uint32_t> lines_;
  std::vector<std::string> unquoted_;
};

// Refuses a NUL byte.
void expect_text(std::string_view text, std::string_view source);
// Reads the whole text, or just more than the readers below take: a stream may have no end. Refuses what is no text.
std::string csv_text(std::istream& stream, std::string_view source);
// `source` is the text's name in messages ("data.csv"). Malformed text throws std::invalid_argument with source:line.
CsvTable parse_csv(std::string_view text, std::string_view source, char separator = ',');

// Appends a cell, or one line of CSV, to `text`.
void append_csv_cell(std::string& text, std::string_view cell);
void append_csv_row(std::string& text, const std::vector<std::string>& cells);

}  // namespace ikbench::results
