// The printed tables of a paper (results/published), as claims, audit and a paper's own tables read them.
#pragma once

#include <SQLiteCpp/Database.h>

#include <string_view>

namespace ikbench::claims {

// Half a unit of the last printed digit: what rounding may have taken from, or added to, "1.7824e-4".
double half_unit(std::string_view printed);

// All tables of a paper for SQL: table-3.csv is table_3, its rows in order. A column has its numbers, and
// COLUMN_as_printed its digits. `said` is one row of what statements.csv has, a column a name.
constexpr std::string_view printed_suffix = "_as_printed";
SQLite::Database printed_database(std::string_view paper);

}  // namespace ikbench::claims
