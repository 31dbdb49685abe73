// Comma-separated values as RFC 4180 has them: quoted where needed, quotes doubled, any text round-trips.
// Lines end in LF or CRLF when read and in LF when written; a byte-order mark and empty lines are skipped.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::results {

constexpr std::size_t max_csv_bytes = std::size_t{1} << 30;
constexpr std::size_t max_csv_columns = 10'000;

struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // each as long as the header

  // Index of a column; std::invalid_argument names the column and those there are.
  std::size_t column(std::string_view name) const;
  // The cell as a number (nan and inf in any case included); std::invalid_argument names row, column and the text.
  double number(std::size_t row, std::string_view column_name) const;
};

// `source` is how messages name the text ("data.csv"). Malformed text is std::invalid_argument with source:line.
CsvTable parse_csv(std::string_view text, std::string_view source);
std::string to_csv(const CsvTable& table);

// One line of CSV at the end of `text`.
void append_csv_row(std::string& text, const std::vector<std::string>& cells);

}  // namespace ikbench::results
