// Google Benchmark's CSV has rows that sum up others, which only their names tell.
// https://github.com/google/benchmark/blob/main/docs/user_guide.md#output-formats
#pragma once

#include <string>
#include <vector>

#include "analysis/csv/layout.hpp"

namespace ikbench::csv {

// Leaves out the rows that sum up others, unless --where takes a name; returns their names.
std::vector<std::string> leave_out_aggregates(Sheet& sheet, const Request& request);

// Refuses times of several units.
void expect_one_time_unit(const Sheet& sheet, const Columns& values);

}  // namespace ikbench::csv
