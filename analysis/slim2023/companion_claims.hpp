// What is claimed beside the six solvers on the helix: real time, the circle, and what our own studies add to it. None
// where the study is not of that kind.
#pragma once

#include <optional>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/claims.hpp"

namespace ikbench::slim2023 {

std::optional<report::Claim> real_time(const inference::StudyResults& study);
std::optional<report::Claim> circle(const inference::StudyResults& study);
std::optional<report::Claim> accurate_inside_limits(const inference::StudyResults& study,
                                                    const inference::JudgedStudy& limits);
std::optional<report::Claim> better_than_classical(const inference::StudyResults& study,
                                                   const inference::StudyResults& context);

}  // namespace ikbench::slim2023
