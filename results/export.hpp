// Writes the solves of a study for other programs.
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
  std::string_view type;  // text, integer, number, list of numbers, or name (one of those in its meaning)
  std::string_view meaning;
};

// The columns of a solve, in their order.
std::vector<ColumnInfo> columns();

// Passes solves on one by one, in the order solver, run, point, as often as it is called.
using PassSolves = std::function<void(const TakeSolve& take)>;

// So begin the names of extras that are an answer [rad, m], 1 the first joint: a program's, where the arm stayed.
constexpr std::string_view refused_extra = "refused_";
// And so those of a study's own check: its numbers, and why an answer is invalid.
constexpr std::string_view check_extra = "check_", invalid_extra = "invalid: ";

// Tidy CSV: one row per solve. A list becomes one column per element, numbered from 1 (answer_rad_1 ...), as many as
// the first solve has; shorter lists leave cells empty, and longer ones throw std::invalid_argument. The trace and the
// improvements have up to one element per iteration, so only the store has them. Values that are not finite are NaN,
// Inf or -Inf; evaluations that nobody counted are empty. Then a column for each of these extras (extra_restarts ...).
void write_csv(const PassSolves& pass, const base::Write& write, const std::vector<std::string>& extras = {});

}  // namespace ikbench::results
