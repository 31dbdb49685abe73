// Rules for what is claimed beside the six solvers on the helix: real time, the circle, the arm. None where no study of
// the report is of that kind.
#pragma once

#include <optional>

#include "analysis/report/paper.hpp"
#include "analysis/slim2023/claim_entries.hpp"

namespace ikbench::slim2023 {

// Table 7's first row, and its others.
std::optional<report::Claim> real_time(const report::Reported& reported, const ClaimEntry& entry);
std::optional<report::Claim> only_offline(const report::Reported& reported, const ClaimEntry& entry);
// Table 8: errors of the order of rounding.
std::optional<report::Claim> circle(const report::Reported& reported, const ClaimEntry& entry);
// What nothing here can decide, for want of what the claim says would.
report::Claim untested(const ClaimEntry& entry);

}  // namespace ikbench::slim2023
