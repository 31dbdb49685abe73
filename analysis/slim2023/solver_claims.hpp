// Rules for what is claimed of a solver against others in means: who is first or last, in which order, which compromise
// is the best, and whether they differ at all. None where the study has no numbers for it.
#pragma once

#include <optional>

#include "analysis/report/paper.hpp"
#include "analysis/slim2023/claim_entries.hpp"

namespace ikbench::slim2023 {

// The solver's mean is the smallest, or the largest, of each of the claim's metrics.
std::optional<report::Claim> smallest(const report::Reported& reported, const ClaimEntry& entry);
std::optional<report::Claim> largest(const report::Reported& reported, const ClaimEntry& entry);
// All solvers in the printed order.
std::optional<report::Claim> ranking(const report::Reported& reported, const ClaimEntry& entry);
// The solver dominates the others: better in one of the metrics and worse in none.
std::optional<report::Claim> compromise(const report::Reported& reported, const ClaimEntry& entry);
// By one-way ANOVA, as the paper tests it.
std::optional<report::Claim> differ(const report::Reported& reported, const ClaimEntry& entry);

}  // namespace ikbench::slim2023
