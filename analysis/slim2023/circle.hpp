// Section 6 of Slim et al. (2023): an arm that draws a circle. Table 8: the angles at every point and the error there.
#pragma once

#include <optional>
#include <string>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::slim2023 {

bool is_circle(const inference::StudyResults& study);

// The first run of the study's first solver. Nothing where the study is not a circle that is held against a printed
// Table 8.
std::optional<report::Table> table_8(const inference::StudyResults& study);

// How many of the printed angles are ours within what their rounding hides; empty where there is no Table 8.
std::string printed_angles_verdict(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
