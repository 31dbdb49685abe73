// Comma-separated values as RFC 4180 has them: quoted where needed, quotes doubled, any text round-trips.
// Lines end in LF or CRLF when read and in LF when written; a byte-order mark and empty lines are skipped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::results {

constexpr std::size_t max_csv_bytes = std::size_t{1} << 30;
constexpr std::size_t max_csv_columns = 10'000;

struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // each as long as the header
  std::vector<std::size_t> lines = {};         // of a text that was read: where each row begins, from 1

  // Index of a column; std::invalid_argument names the column and those there are.
  std::size_t column(std::string_view name) const;
  // The cell as a number (nan and inf in any case included); std::invalid_argument names row, column and the text.
  double number(std::size_t row, std::string_view column_name) const;
};

// The same for files of millions of rows: views of the text, which has to outlive them, and 4 bytes beside it for each
// cell. Cells that were in quotes are kept without them.
class CsvView {
 public:
  std::vector<std::string> header;

  explicit CsvView(std::string_view text) : text_(text) {}
  std::size_t rows() const { return header.empty() ? 0 : places_.size() / header.size(); }
  std::string_view cell(std::size_t row, std::size_t column) const;
  void append_plain(
      std::string_view cell);  // a part of the text, with a comma, the end of the line or nothing behind it
  void append_unquoted(std::string cell);

 private:
  std::string_view text_;
  std::vector<std::uint32_t> places_;  // row by row: where a cell begins, or, behind the text's end, which of unquoted_
  std::vector<std::string> unquoted_;
};

// `source` is how messages name the text ("data.csv"). Malformed text is std::invalid_argument with source:line.
CsvTable parse_csv(std::string_view text, std::string_view source);
CsvView view_csv(std::string_view text, std::string_view source);
std::string to_csv(const CsvTable& table);

// One line of CSV at the end of `text`.
void append_csv_row(std::string& text, const std::vector<std::string>& cells);

}  // namespace ikbench::results
