// The rules that judge claims, and the claims of a paper judged by them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// A rule returns no claim if the report has nothing to judge, and several if the sentence is about many: "{solver} on
// the {arm}".
using Rule = Claims (*)(const Case& of);
Rule rule_of(std::string_view name);  // null if there is none of that name
std::vector<std::string> rule_names();

// The judged claims. For a study that is compared with the paper's means: all claims of the paper, untested ones
// included. Our claims, and claims about another study, only if there are numbers for them.
Claims judged(const ClaimsFile& file, const report::Reported& reported);

}  // namespace ikbench::claims
