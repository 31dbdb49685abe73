// Exports a store for other programs: the formats, and the list of columns that tidy CSV and JSON share.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/files.hpp"
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
// True if the column has no value: nobody counted the evaluations.
bool is_uncounted(std::string_view column, const SolveRecord& record);

// Passes solves on one by one, as often as it is called.
using PassSolves = std::function<void(const TakeSolve& take)>;

// The exported solves and their study. The solves are in the order solver, run, point.
struct Exported {
  const StoredStudy& study;
  const std::vector<Session>& sessions;
  PassSolves each_solve;
};

// A format is either a text, which is written in parts, or a folder, which must be absent or empty. Both functions
// throw std::invalid_argument if the format cannot hold the study. `write_folder` returns warnings.
struct ExportFormat {
  std::string_view name;
  std::string_view meaning;
  void (*write_text)(const Exported& exported, const Write& write) = nullptr;
  std::vector<std::string> (*write_folder)(const Exported& exported, const std::filesystem::path& folder) = nullptr;
};

// The formats in the order of export_formats.inc.
std::span<const ExportFormat> export_formats();
// The one of that name; there must be one.
const ExportFormat& export_format(std::string_view name);

// Writes the CSV of solves into a file.
void write_csv(const std::filesystem::path& file, const PassSolves& pass);

}  // namespace ikbench::results
