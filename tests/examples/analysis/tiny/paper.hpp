// A paper of one claim, one printed table and one figure: the example of docs/adding-anything.md.
#pragma once

#include "analysis/report/paper.hpp"

namespace ikbench::tiny {

report::Paper paper();

}  // namespace ikbench::tiny
