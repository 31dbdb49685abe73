// Table 7 of Slim et al. (2023): the time of a solve to the tolerance, at random targets.
#pragma once

#include <optional>
#include <string>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::slim2023 {

constexpr double real_time_ms = 50;  // shorter solves leave room for 20 per second

// Nothing unless the study has random targets and a printed Table 7.
std::optional<report::Table> table_7(const inference::StudyResults& study);

// The number of solves that reached the tolerance in real time, and those that did not; empty if there is no Table 7.
std::string real_time_verdict(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
