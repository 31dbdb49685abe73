// Reads CSV files of Google Benchmark, which have rows that sum up other rows. Such rows are known only by their names.
// user_csv.cpp calls these functions for every file. Google documents the format:
// https://github.com/google/benchmark/blob/main/docs/user_guide.md#output-formats
#pragma once

#include <string>
#include <vector>

#include "analysis/csv/layout.hpp"

namespace ikbench::csv {

// Leaves out the rows that sum up other rows, unless --where takes a name, and returns the names of these rows. Does
// nothing to files of other programs.
std::vector<std::string> leave_out_aggregates(Sheet& sheet, const Request& request);

// Throws std::invalid_argument, as Sheet does, if the times of a file have several units.
void expect_one_time_unit(const Sheet& sheet, const Columns& values);

}  // namespace ikbench::csv
