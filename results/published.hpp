// Published tables, embedded in the program: results/published/<paper>/<table>.csv.
#pragma once

#include <string_view>
#include <vector>

#include "base/csv.hpp"

namespace ikbench::results::published {

// The table as printed, e.g. table("slim2023", "table-3"); without rows if there is none.
base::CsvTable table(std::string_view paper, std::string_view name);
std::vector<std::string_view> papers();

}  // namespace ikbench::results::published
