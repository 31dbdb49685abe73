// Table 7 of Slim et al. (2023): how long a solve takes until it comes to the tolerance, at random targets.
#pragma once

#include <optional>
#include <string>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::slim2023 {

constexpr double real_time_ms = 50;  // a solve that takes less leaves room for 20 a second

// Nothing where the study is not one of random targets that is held against a printed Table 7.
std::optional<report::Table> table_7(const inference::StudyResults& study);

// What the tolerance costs, by expected running times with intervals, beside the paper's ratios.
// Nothing where there is no Table 7, the study has no tolerance, or times are not comparable.
std::optional<report::Table> table_7_cost(const inference::StudyResults& study);

// How many solves came to the tolerance in real time, and which did not; empty where there is no Table 7.
std::string real_time_verdict(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
