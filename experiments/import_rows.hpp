// A CSV of somebody's solves as rows, checked one by one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robots/chain.hpp"

namespace ikbench::experiments {

struct ImportedRow {
  std::string where;  // "my.csv:3", for messages
  std::string label;
  int run = 0, point = 0;
  std::vector<double> answer = {};  // [rad], of joints that slide [m]; empty: not known
  std::optional<double> position_error_cm = {}, orientation_error_deg = {}, seconds = {};
  std::optional<std::int64_t> evaluations = {};
  std::vector<double> target_position_m = {};  // empty: the file does not say
};

struct ImportedRows {
  std::vector<ImportedRow> rows;
  std::vector<std::string> unread;  // columns that `ikbench export` writes, but that are not taken from a file
};

// The columns that import.hpp lists; `label` is of rows without one. std::invalid_argument names file, line and column.
ImportedRows read_imported_rows(const std::string& text, const std::string& source, const std::string& label,
                                const robots::Configuration& joint_units);

}  // namespace ikbench::experiments
