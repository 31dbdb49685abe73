// The rules that judge claims, and the claims of a paper judged by them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// None where a report has nothing that it could judge; several where its sentence is of many: "{solver} on the {arm}".
using Rule = std::vector<report::Claim> (*)(const Case& of);
Rule rule_of(std::string_view name);  // null where there is none of that name
std::vector<std::string> rule_names();

// Of a study that is held against the paper's means all that the paper makes: what a report cannot judge is told to be
// untested. Ours, and claims about another study, where there are numbers for them.
std::vector<report::Claim> judged(const ClaimsFile& file, const report::Reported& reported);

}  // namespace ikbench::claims
