// Cells of a table by row and column name, for tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <variant>

#include "analysis/report/table.hpp"

namespace ikbench {

inline const report::Cell& cell_at(const report::Table& table, std::size_t row, const std::string& column) {
  const auto found = std::ranges::find(table.columns, column);
  if (found == table.columns.end()) throw std::invalid_argument("no column " + column);
  return table.rows.at(row).at(static_cast<std::size_t>(found - table.columns.begin()));
}

// NaN where the cell is no number.
inline double number_at(const report::Table& table, std::size_t row, const std::string& column) {
  const report::Cell& cell = cell_at(table, row, column);
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*count);
  if (const auto* value = std::get_if<double>(&cell)) return *value;
  if (const auto* beside = std::get_if<report::OursAndPrinted>(&cell)) return beside->ours;
  return std::numeric_limits<double>::quiet_NaN();
}

inline bool is_empty(const report::Table& table, std::size_t row, const std::string& column) {
  return report::is_empty(cell_at(table, row, column));
}

inline bool has_note(const report::Table& table, const std::string& words) {
  return std::ranges::any_of(table.notes,
                             [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

}  // namespace ikbench
