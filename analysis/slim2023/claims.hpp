// The verdict on Slim et al. (2023): the claims of claims.toml, each judged by the rule that it names.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/report/paper.hpp"
#include "analysis/slim2023/claim_entries.hpp"

namespace ikbench::slim2023 {

// None where a report has nothing that it could judge.
using ClaimRule = std::function<std::optional<report::Claim>(const report::Reported&, const ClaimEntry&)>;
const std::vector<std::pair<std::string, ClaimRule>>& claim_rules();
std::vector<std::string> claim_tests();  // their names

std::vector<report::Claim> judged_claims(const report::Reported& reported, const std::vector<ClaimEntry>& entries);

// The paper's. Of a study that is held against Table 3 all that the paper makes: what a report cannot judge is told to
// be untested. Ours, and claims about another study, where there are numbers for them.
std::vector<report::Claim> claims(const report::Reported& reported);

}  // namespace ikbench::slim2023
