// Who is first, and in which order the others follow.
#pragma once

#include <optional>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/slim2023/paper_tables.hpp"

namespace ikbench::slim2023 {

// None where fewer than two solvers are printed.
std::optional<report::Claim> most_accurate(const inference::JudgedStudy& study, const std::vector<Comparison>& rows);
std::optional<report::Claim> accuracy(const inference::JudgedStudy& study, const std::vector<Comparison>& rows);
std::optional<report::Claim> computing_time(const inference::JudgedStudy& study, const std::vector<Comparison>& rows);

}  // namespace ikbench::slim2023
