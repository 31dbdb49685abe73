// A user's table as pandas, R, spreadsheets and recorders write it: cells parted by a comma, semicolon, tab, bar or
// blanks, point or comma in numbers, comments before the header or the header as the last of them. A mistake in it
// throws std::invalid_argument: FILE:LINE:COLUMN, what is wrong and what to do.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/csv.hpp"
#include "base/names.hpp"

namespace ikbench::base {

constexpr std::ptrdiff_t most_lines = 10'000'000;  // of solves a study may have as many

using Words = std::initializer_list<std::string_view>;
bool is_one_of(std::string_view text, const Words& words);  // in any case
std::string unnamed(std::size_t column);                    // the title of one that has none

// "error_cm", "error [cm]" and "error (cm)" have a unit, of lengths, angles or times; in [] any.
struct Title {
  std::string name, unit;
  explicit Title(std::string_view title);
};

class Sheet {
 public:
  // `optional`: columns are named "1", "2" ... where the first line has numbers alone.
  enum class Header { required, optional };
  // The mark of decimals is found where it is 0. The text must outlive the sheet.
  Sheet(std::string_view text, std::string_view source, char decimal, Header header = Header::required);

  // Takes the rows with this value in this column alone, "metric=error"; returns the column.
  std::size_t choose(std::string_view condition);

  const std::vector<std::string>& titles() const { return titles_; }
  // Rows that have a text: spreadsheets leave empty ones.
  const std::vector<std::uint32_t>& rows() const { return rows_; }
  std::string_view cell(std::size_t row, std::size_t column) const;  // without blanks at its ends

  // `row` is, where the file has none, a new one of the number of each row.
  std::size_t column(std::string_view name);
  // The column of this name; of several a new one, of their texts joined by " / ", empty where one of them is.
  std::size_t joined(const std::vector<std::string>& names);
  std::optional<std::size_t> column_like(const Words& names) const;  // named so; earlier names first
  // Of the first 1000 cells most but those missing, or all are True and False.
  bool has_numbers(std::size_t column) const;
  // Not a number where it is missing. "1.020" may be 1.02 or 1020: other cells of the column say which mark is of
  // decimals, else those of the file, else the comma that parts cells, else the column is refused.
  double number(std::size_t row, std::size_t column);

  std::string said(std::string_view what) const;  // of the file
  [[noreturn]] void refuse(std::string_view what) const;
  [[noreturn]] void refuse(std::size_t row, std::size_t column, std::string_view what) const;

 private:
  std::string source_;
  char separator_, decimal_;
  CsvTable table_;
  std::vector<std::string> titles_;
  std::vector<std::uint32_t> rows_;
  std::vector<std::vector<std::string>> joined_;  // columns after the file's
  std::vector<char> decimals_;                    // of each column; 0: not known yet
  std::optional<std::set<char>> marks_;           // of all columns, where they had to be asked

  char decimal_of(std::size_t column);
};

}  // namespace ikbench::base
