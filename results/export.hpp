// Exports a store for other programs: tidy CSV and JSON, and the list of columns that both share.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::results {

struct ColumnInfo {
  std::string_view name;
  std::string_view type;  // text, integer, number, list of numbers, or name (one of those in its meaning)
  std::string_view meaning;
};

// The columns of a solve, in their order.
std::vector<ColumnInfo> columns();

// One row per solve. A list becomes one column per element, numbered from 1 (answer_rad_1 ...), as many as the longest
// has; shorter lists leave cells empty. The trace and the improvements have up to one element per iteration, so only
// JSON has them. Values that are not finite are NaN, Inf or -Inf.
std::string to_csv(const std::vector<SolveRecord>& records);
// Writes the same to a file, from solves that `pass` passes on one by one. It calls `pass` again if a list is longer
// than that of the first solve.
using PassSolves = std::function<void(const std::function<void(const SolveRecord&)>& take)>;
void write_csv(const std::filesystem::path& file, const PassSolves& pass);

// One object: note, columns, study, definition, series, sessions, solves. null stands for NaN and infinities, which
// JSON does not have.
std::string to_json(const StudyEntry& study, const std::vector<Session>& sessions,
                    const std::vector<SolveRecord>& records);

}  // namespace ikbench::results
