// The audit of a paper: every item of its audit.toml is SQL over its printed tables, and what follows from them in
// words. Nothing is solved.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/report/audit.hpp"

namespace ikbench::claims {

// The items of an audit.toml, judged; `source` is how messages name it. A query that fails, or whatever is missing or
// unknown, is std::invalid_argument with the item's line; so is a paper that is not among the published.
std::vector<report::AuditItem> audited(std::string_view paper, std::string_view text, std::string_view source);

// A printed number against the one that follows; `slack` is what the rounding of what it follows from may change.
report::Verdict judged(std::string_view printed, double follows, double slack);

}  // namespace ikbench::claims
