// A CSV as its cells, and back.
#pragma once

#include "base/csv.hpp"
#include "tests/common.hpp"

namespace ikbench {

// The cells of a CSV, row by row; the first is the header.
using Cells = std::vector<std::vector<std::string>>;

inline Cells cells_of(const base::CsvTable& table) {
  Cells cells{table.header};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::vector<std::string>& cells_of_row = cells.emplace_back();
    for (std::size_t column = 0; column < table.header.size(); ++column)
      cells_of_row.emplace_back(table.cell(row, column));
  }
  return cells;
}

inline std::string to_csv(const Cells& cells) {
  std::string text;
  for (const auto& row : cells) base::append_csv_row(text, row);
  return text;
}

}  // namespace ikbench
