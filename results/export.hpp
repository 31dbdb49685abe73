// Writes the solves of a study for other programs: as CSV with one row per solve.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "base/files.hpp"
#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::results {

struct ColumnInfo {
  std::string_view name;
  std::string_view type;  // text, integer, number, list of numbers, or name (one of those that `meaning` lists)
  std::string_view meaning;
};

// Returns the columns of a solve, in the order of the store.
std::vector<ColumnInfo> columns();

// Passes solves on one by one, in the order solver, run, point. A call begins again at the first solve.
using SolveSource = std::function<void(const SolveVisitor& take)>;

// The beginning of the names of extras that hold a refused answer [rad, m] of a program: `refused_1` is its first
// joint. The arm stayed where it was.
constexpr std::string_view refused_prefix = "refused_";
// The beginnings of the names of extras that a study's own check gives: its numbers, and why an answer is invalid.
constexpr std::string_view check_extra = "check_", invalid_extra = "invalid: ";

// Writes tidy CSV: one row per solve, then a column per name in `extras` (`extra_restarts`, ...).
// A list becomes one column per element, numbered from 1 (`answer_rad_1`), as many as the first solve has. A shorter
// list leaves cells empty; a longer one throws std::invalid_argument. The trace and the improvements are left out,
// because they have up to one element per iteration: only the store has them. Values that are not finite are written as
// NaN, Inf or -Inf. Evaluations that nobody counted are empty.
void write_csv(const SolveSource& pass, const base::Write& write, const std::vector<std::string>& extras = {});

}  // namespace ikbench::results
