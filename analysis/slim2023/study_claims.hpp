// Rules for what is claimed of a solver beside its means: at each point, over the runs, of its joints, and of an
// equation of it. None where the study has no numbers for it.
#pragma once

#include <optional>

#include "analysis/report/paper.hpp"
#include "analysis/slim2023/claim_entries.hpp"

namespace ikbench::slim2023 {

// Its error, averaged over the runs, is the smallest at each point.
std::optional<report::Claim> least_at_each_point(const report::Reported& reported, const ClaimEntry& entry);
// The standard deviation over its runs is the smallest, by Brown and Forsythe's test of each pair, after Holm.
std::optional<report::Claim> least_spread(const report::Reported& reported, const ClaimEntry& entry);
// Second differences of the angles along the path, and the largest move of a joint.
std::optional<report::Claim> smoothest(const report::Reported& reported, const ClaimEntry& entry);
// No answer has a joint outside its limits.
std::optional<report::Claim> inside_limits(const report::Reported& reported, const ClaimEntry& entry);
// Its metric is smaller than in the companion that goes without something; it fails where no answer changes.
std::optional<report::Claim> has_effect(const report::Reported& reported, const ClaimEntry& entry);
// Never decided; how near answers come to a stretched elbow or an aligned wrist is told.
std::optional<report::Claim> singularities(const report::Reported& reported, const ClaimEntry& entry);

}  // namespace ikbench::slim2023
