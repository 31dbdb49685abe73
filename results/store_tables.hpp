// What is written into the tables of studies and sessions, within the caller's transaction.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <map>
#include <string>

#include "results/store.hpp"

namespace ikbench::results {

// Replaces one of the same name.
void write_study(SQLite::Database& sqlite, const StudyEntry& study);

// The session has none of these keys yet.
void write_environment(SQLite::Database& sqlite, std::int64_t session,
                       const std::map<std::string, std::string>& environment);

}  // namespace ikbench::results
