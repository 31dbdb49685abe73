// What a store holds, for other programs: tidy CSV and JSON, and the list of columns that both share.
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
// has; shorter ones leave cells empty. The trace and the improvements are left out: they have up to one element per
// iteration; JSON has them. What is not finite is NaN, Inf or -Inf.
std::string to_csv(const std::vector<SolveRecord>& records);
// The same as a file, from solves that `pass` passes on one after another. It does so again where a list is longer than
// those of the first solve.
using PassSolves = std::function<void(const std::function<void(const SolveRecord&)>& take)>;
void write_csv(const std::filesystem::path& file, const PassSolves& pass);

// One object: note, columns, study, definition, series, sessions, solves. JSON has no number that is not finite:
// null stands for NaN and for infinities.
std::string to_json(const StudyEntry& study, const std::vector<Session>& sessions,
                    const std::vector<SolveRecord>& records);

}  // namespace ikbench::results
