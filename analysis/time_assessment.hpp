// Table 7 of Slim et al. (2023): how long a solve takes until it comes to the tolerance, at random targets.
#pragma once

#include <optional>
#include <string>

#include "analysis/study.hpp"
#include "analysis/table.hpp"

namespace ikbench {

constexpr double real_time_ms = 50;  // a solve that takes less leaves room for 20 a second

// Nothing where the study is not one of random targets that is held against a printed Table 7.
std::optional<Table> table_7(const StudyResults& study);

// Whether every solve was done in real time, and which was not; empty where there is no Table 7.
std::string real_time_verdict(const StudyResults& study);

}  // namespace ikbench
