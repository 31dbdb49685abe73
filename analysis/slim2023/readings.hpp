// Readings of a paper held against its printed Table 3: which one moves which number, and how far from the paper.
#pragma once

#include <span>
#include <string_view>

#include "analysis/report/readings.hpp"

namespace ikbench::slim2023 {

// The first of the readings is the default, by which the others are measured. std::invalid_argument where there is
// none.
report::ReadingsReport readings_report(std::string_view paper, std::span<const report::ReadingResults> readings);

}  // namespace ikbench::slim2023
