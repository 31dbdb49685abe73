// Reads a user's CSV cell by cell. Error messages say what was found, where, and what to write instead.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/csv.hpp"

namespace ikbench::inference {

constexpr std::size_t longest_name = 1000;  // longest name of a group or a quantity [bytes]

// A parsed file and its name in messages. The text must outlive it.
struct CsvFile {
  std::string source;
  results::CsvView table;
  std::vector<bool> blank = {};  // by row: all its cells are empty (cached for every column)

  [[noreturn]] void refuse(std::string_view what) const;
  // Refuses a cell: the message names its row, its column and its text.
  [[noreturn]] void refuse_cell(std::size_t row, std::size_t column, std::string_view what) const;

  // Index of a column. If it is missing, throws std::invalid_argument with a list of all columns.
  std::size_t column(std::string_view name) const;
  // The names of all columns, for a message.
  std::string columns() const;
  // The cell as a group's name, "(empty)" for an empty cell. Throws std::invalid_argument if it is too long.
  std::string group_name(std::size_t row, std::size_t column) const;
  // The first column with one of the names, in any case; nullopt if there is none.
  std::optional<std::size_t> column_like(std::span<const std::string_view> names) const;

  // The cell's number; nullopt if it is missing: empty, NA, N/A, NaN, null, None or <NA>, in any case.
  std::optional<double> number(std::size_t row, std::size_t column) const;
  // Returns whether all cells of the row are empty: spreadsheets leave such rows below a table.
  bool is_blank(std::size_t row) const;
  // The file's name without its folders, as one line.
  std::string name() const;
};

// Throws std::invalid_argument for a file without rows, or with another separator than commas.
CsvFile open_csv(std::string_view text, std::string_view source);

bool is_missing(std::string_view cell);
// Without spaces at both ends.
std::string_view trimmed(std::string_view name);
std::string lower_case(std::string_view text);  // ASCII letters only
// Keeps letters, digits and '-' for names of files and anchors; "value" if nothing is left.
std::string slug(std::string_view text);
// Quotes a text of the file for a message: one line, shortened.
std::string in_quotes(std::string_view text);

}  // namespace ikbench::inference
