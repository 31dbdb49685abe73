// The arms of the library side by side: no paper, but studies that are read together as a paper's are.
#pragma once

#include "analysis/report/paper.hpp"

namespace ikbench::arms {

report::Paper paper();

}  // namespace ikbench::arms
