// A user's table as pandas, R, spreadsheets and recorders write it. Cells are separated by a comma, semicolon, tab, bar
// or blanks; numbers have a point or a comma; comments may stand before the header, or the header may be the last of
// them. A mistake throws std::invalid_argument: FILE:LINE:COLUMN, what is wrong and what to do.
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

constexpr std::ptrdiff_t max_lines = 10'000'000;  // a study may have as many solves

using Words = std::initializer_list<std::string_view>;
bool is_one_of(std::string_view text, const Words& words);  // in upper or lower case
std::string unnamed(std::size_t column);                    // title of a column that has none

// A title with its unit. "error_cm", "error [cm]" and "error (cm)" have the unit cm. Known units are those of lengths,
// angles and times; in brackets [] any unit is taken.
struct Title {
  std::string name, unit;
  explicit Title(std::string_view title);
};

// A table with its titles. Numbers are read cell by cell, when they are asked for.
class Sheet {
 public:
  // `optional`: if the first line has only numbers, columns are named "1", "2" ...
  enum class Header { required, optional };
  // Reads the table. `decimal` is the mark of decimals; 0: it is found. The text has to outlive the sheet.
  Sheet(std::string_view text, std::string_view source, char decimal, Header header = Header::required,
        std::size_t max_bytes = max_csv_bytes);

  // Keeps only the rows with this value in this column, "metric=error". Returns the column.
  std::size_t choose(std::string_view condition);

  void leave_out(const std::vector<std::uint32_t>& rows);

  const std::vector<std::string>& titles() const { return titles_; }
  // Rows with at least one text. Spreadsheets leave empty rows.
  const std::vector<std::uint32_t>& rows() const { return rows_; }
  std::string_view cell(std::size_t row, std::size_t column) const;     // without blanks at both ends
  std::size_t line(std::size_t row) const { return table_.line(row); }  // line where the row begins, from 1

  // Returns the column of this name. If the file has no column `row`, that name gives a new column with the number of
  // each row.
  std::size_t column(std::string_view name);
  // Returns the column of one name. For several names, returns a new column of their texts, joined by " / " and empty
  // where one of them is.
  std::size_t joined(const std::vector<std::string>& names);
  std::optional<std::size_t> column_like(const Words& names) const;  // by one of these names, the first that exists
  // Returns true if most of the first 1000 cells that are not missing are numbers, or all are True and False.
  bool has_numbers(std::size_t column) const;
  // Returns a cell as a number; NaN if it is missing. "1.020" may be 1.02 or 1020. Other cells of the column tell which
  // mark is of decimals, otherwise those of the file. If commas separate cells, the mark is a point. If nothing tells,
  // throws std::invalid_argument.
  double number(std::size_t row, std::size_t column);

  // Says what to write in place of a cell that is no number: of files that know missing values otherwise than `stats`.
  void advise_on_numbers(std::string_view advice) { advice_on_numbers_ = advice; }

  // Refuses a column of which all cells are a number with its unit or spread: "42.6 %", "1.06 ms", "1.2 ± 0.1".
  void refuse_units(std::size_t column) const;

  std::string said(std::string_view what) const;  // of the file
  [[noreturn]] void refuse(std::string_view what) const;
  [[noreturn]] void refuse(std::size_t row, std::size_t column, std::string_view what) const;

 private:
  std::string source_;
  std::string advice_on_numbers_ = "write NA for a missing value, inf for no answer, and units in the header";
  char separator_, decimal_;
  CsvTable table_;
  std::vector<std::string> titles_;
  std::vector<std::uint32_t> rows_;
  std::vector<std::vector<std::string>> joined_;  // columns behind those of the file
  std::vector<char> decimals_;                    // mark of decimals per column; 0: not known yet
  std::optional<std::set<char>> marks_;           // marks of all columns, if they were needed

  char decimal_of(std::size_t column);
  void refuse_second_header() const;
};

}  // namespace ikbench::base
