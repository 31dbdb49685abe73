// Reads a CSV of somebody's solves as rows, and checks them one by one.
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
  std::vector<double> answer = {};  // [rad], or [m] where a joint slides; empty: not given
  std::optional<double> position_error_cm = {}, orientation_error_deg = {}, seconds = {};
  std::optional<std::int64_t> evaluations = {};
  std::vector<double> target_position_m = {};  // empty: not given
};

struct ImportedRows {
  std::vector<ImportedRow> rows;
  std::vector<std::string> unread;  // columns of `ikbench export` that an import ignores
};

// Reads the columns that import.hpp lists. `label` is for rows without one. std::invalid_argument names file, line and
// column.
ImportedRows read_imported_rows(const std::string& text, const std::string& source, const std::string& label,
                                const robots::Configuration& joint_units);

}  // namespace ikbench::experiments
