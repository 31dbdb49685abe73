// The audit of a paper: every item of its audit.toml is SQL over its printed tables, with the conclusion in words.
// Nothing is solved.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/report/audit.hpp"

namespace ikbench::claims {

// Judges the items of an audit.toml; `source` is its name in messages. Throws std::invalid_argument with the item's
// line for a query that fails, for anything missing or unknown, and for a paper that is not published.
std::vector<report::AuditItem> audited(std::string_view paper, std::string_view text, std::string_view source);

// Compares a printed number with the one that follows; `slack` is the possible change of the latter by the rounding of
// its sources.
report::Verdict judged(std::string_view printed, double follows, double slack);

}  // namespace ikbench::claims
