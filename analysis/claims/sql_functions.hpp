// Functions for an audit of printed numbers, besides SQLite's own.
//
// For one row: half_unit(text), f_tail(F, df_between, df_within) and impossible(mean, median, std, max, min, n). For
// the groups of a table, one row each: anova_f, anova_level, welch_f and welch_p(mean, std, n); anova_slack(mean, std,
// n, half_unit of mean, of std); tukey_p and games_howell_p(mean, std, n, whether it is one of the pair).
#pragma once

#include <SQLiteCpp/Database.h>

#include <string>

namespace ikbench::claims {

void add_functions(SQLite::Database& database);

// Says why no sample of n has these five statistics; empty if one may.
std::string impossible(double mean, double median, double std, double max, double min, double n);

}  // namespace ikbench::claims
