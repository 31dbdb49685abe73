// Reads a user's CSV cell by cell. Every mistake throws std::invalid_argument: one sentence with the file, the row and
// what was expected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results/csv.hpp"

namespace ikbench::inference {

using Index = std::uint32_t;  // counts cells, since a text has at most max_csv_bytes
static_assert(results::max_csv_bytes < std::numeric_limits<Index>::max());

// A file with commas and at least one row. The text must outlive it.
class CsvFile {
 public:
  CsvFile(std::string_view text, std::string_view source);

  const std::vector<std::string>& header() const { return table_.header; }
  // Numbers of the rows below the header that have a cell with a text: spreadsheets leave empty rows below a table.
  const std::vector<Index>& rows() const { return rows_; }
  std::string_view cell(std::size_t row, std::size_t column) const { return table_.cell(row, column); }
  // The number in a cell; not defined if it is missing: empty, NA, N/A, NaN, null, None or <NA>, in any case.
  double number(std::size_t row, std::size_t column) const;
  // A cell or a title as the name of a group, "(empty)" if there is none.
  std::string name_in(std::string_view text) const;

  std::size_t column(std::string_view name) const;  // refuses a missing one, and lists all columns
  // The first column with one of these names, in any case; nullopt if there is none.
  std::optional<std::size_t> column_like(std::initializer_list<std::string_view> names) const;
  std::string columns() const;    // the names of all columns, for a message
  std::string file_name() const;  // without folders, as one line

  [[noreturn]] void refuse(std::string_view what) const;
  // Refuses a cell: the message has its row, its column and its text.
  [[noreturn]] void refuse_cell(std::size_t row, std::size_t column, std::string_view what) const;

 private:
  std::string source_;
  results::CsvView table_;
  std::vector<Index> rows_;
};

bool is_missing(std::string_view cell);
std::string_view trimmed(std::string_view text);  // without blanks at both ends
std::string lower_case(std::string_view text);    // ASCII letters only
std::string in_quotes(std::string_view text);     // one line, shortened, for a message
// Keeps letters, digits and '-' for names of files and anchors; "value" if nothing is left.
std::string slug(std::string_view text);

}  // namespace ikbench::inference
