// The printed tables of papers, embedded in the program from results/published/<paper>/<table>.csv. Reports show them
// beside repeated numbers.
#pragma once

#include <string_view>
#include <vector>

#include "base/csv.hpp"

namespace ikbench::results::published {

// Returns the table as printed, e.g. table("slim2023", "table-3"); without rows if there is none.
base::CsvTable table(std::string_view paper, std::string_view name);
// Returns the names of all papers with a table.
std::vector<std::string_view> papers();

}  // namespace ikbench::results::published
