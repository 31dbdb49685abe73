// The audit of a paper: every item of its audit.toml is SQL over its printed tables, with the conclusion in words.
// Nothing is solved.
//
// Functions for it, besides SQLite's own. For one row: half_unit(text), f_tail(F, df_between, df_within) and
// impossible(mean, median, std, max, min, n). For the groups of a table, one row each: anova_f, anova_level, welch_f
// and welch_p(mean, std, n); anova_slack(mean, std, n, half_unit of mean, of std); tukey_p and games_howell_p(mean,
// std, n, whether it is one of the pair).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/claims.hpp"

namespace ikbench::claims {

// Judges the items of an audit.toml; `source` is its name in messages. Throws std::invalid_argument with the item's
// line for a query that fails, for anything missing or unknown, and for a paper that is not published.
std::vector<report::AuditItem> audited(std::string_view paper, std::string_view text, std::string_view source);

// Says why no sample of n has these five statistics; empty if one may.
std::string impossible(double mean, double median, double std, double max, double min, double n);

// Compares a printed number with the one that follows; `slack` is the possible change of the latter by the rounding of
// its sources.
report::Verdict judged(std::string_view printed, double follows, double slack);

}  // namespace ikbench::claims
