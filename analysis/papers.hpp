// The papers by name. One line a paper in papers.inc; the folder of that name defines its paper().
#pragma once

#include <string_view>
#include <vector>

#include "analysis/report/paper.hpp"

namespace ikbench::analysis {

// In the order of papers.inc; there is one at least.
const std::vector<report::Paper>& papers();
// std::invalid_argument names those there are.
const report::Paper& paper(std::string_view name);

}  // namespace ikbench::analysis
