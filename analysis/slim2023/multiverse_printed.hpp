// Which universe is the paper's: how many of its printed numbers of error and variation each of them explains.
#pragma once

#include <string_view>

#include "analysis/inference/multiverse.hpp"
#include "analysis/report/multiverse.hpp"

namespace ikbench::slim2023 {

// Adds tables and sentences. A printed number is explained where it lies, but for its rounding, in the range that 95 %
// of studies of as many runs would have by that universe. Nothing is added where no
// solver is printed or there are too few runs.
void add_printed(report::MultiverseReport& report, std::string_view paper, const inference::Multiverse& multiverse);

}  // namespace ikbench::slim2023
