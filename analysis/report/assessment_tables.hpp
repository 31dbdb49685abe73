// The tables of an assessment.
#pragma once

#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

std::vector<Table> tables_of(const inference::Evidence& evidence);

}  // namespace ikbench::report
