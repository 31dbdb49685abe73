// What a user's CSV holds, cell by cell, with messages that say what was found, where, and what to write instead.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/csv.hpp"

namespace ikbench::inference {

constexpr std::size_t longest_name = 1000;  // of a group or a quantity, in bytes

// A parsed file and how messages name it. Its text has to outlive it.
struct CsvFile {
  std::string source;
  results::CsvView table;
  std::vector<bool> blank = {};  // of each row, whether all its cells are empty: asked for again with every column

  [[noreturn]] void refuse(std::string_view what) const;
  // Of a cell: names its row, its column and its text.
  [[noreturn]] void refuse_cell(std::size_t row, std::size_t column, std::string_view what) const;

  // Index of a column; std::invalid_argument lists those there are.
  std::size_t column(std::string_view name) const;
  // The names of all columns, for a message.
  std::string columns() const;
  // The cell as the name of a group, "(empty)" where it is; std::invalid_argument where it is too long for one.
  std::string group_name(std::size_t row, std::size_t column) const;
  // The first column with one of the names, in any case; nothing where there is none.
  std::optional<std::size_t> column_like(std::span<const std::string_view> names) const;

  // The cell's number; nothing where it is missing: empty, NA, N/A, NaN, null, None or <NA>, in any case.
  std::optional<double> number(std::size_t row, std::size_t column) const;
  // All cells of the row are empty, as spreadsheets leave them below a table.
  bool is_blank(std::size_t row) const;
  // The file's name without its folders, as one line.
  std::string name() const;
};

// A file without rows, or whose columns are separated by anything but commas, is std::invalid_argument.
CsvFile open_csv(std::string_view text, std::string_view source);

bool is_missing(std::string_view cell);
std::string lower_case(std::string_view text);  // ASCII letters only
// Letters, digits and '-', for names of files and anchors; "value" where nothing is left.
std::string slug(std::string_view text);
// A text of the file within a message: one line, not too long.
std::string in_quotes(std::string_view text);

}  // namespace ikbench::inference
