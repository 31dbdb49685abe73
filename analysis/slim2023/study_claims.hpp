// What is claimed of the six solvers beside their ranking: how much they move the joints, that they differ, and that
// answers are inside the joint limits.
#pragma once

#include <optional>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/slim2023/paper_tables.hpp"

namespace ikbench::slim2023 {

std::vector<report::Claim> variation(const inference::JudgedStudy& study, const std::vector<Comparison>& rows);
std::optional<report::Claim> solvers_differ(const inference::StudyResults& study);
std::optional<report::Claim> inside_limits(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
