// Section 6 of Slim et al. (2023): an arm that draws a circle. Table 8: the angles at every point and the error there.
#pragma once

#include <optional>
#include <string>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::slim2023 {

bool is_circle(const inference::StudyResults& study);

// Table 8 for the first run of the study's first solver. Nothing unless the study is a circle with a printed Table 8.
std::optional<report::Table> table_8(const inference::StudyResults& study);

// The joint angles of that run beside the printed ones. Nothing if there is no Table 8.
std::optional<figures::Figure> printed_joints_figure(const inference::StudyResults& study, const std::string& name);

// The number of printed angles that ours equal within their rounding; empty if there is no Table 8.
std::string printed_angles_verdict(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
