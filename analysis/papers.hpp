// The papers by name: the folders here that have a paper.toml, which the build carries in the program with the
// claims beside it. What a paper has of its own in C++ is a line in papers.inc; the folder of that name defines its
// complete(). They stand first.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/report/paper.hpp"

namespace ikbench::analysis {

const std::vector<report::Paper>& papers();  // there is one at least
// std::invalid_argument names those there are.
const report::Paper& paper(std::string_view name);

}  // namespace ikbench::analysis
