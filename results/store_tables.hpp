// Writes the tables, within the caller's transaction, and reads studies as they stand there.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

constexpr std::int64_t no_end = std::numeric_limits<std::int64_t>::max();
// The last run of a study, and its last point, or no_end. Throws Damage if the definition has no runs.
struct Last {
  std::int64_t run, point;
};
Last last_of(const StudyEntry& study);

std::vector<Series> series_in(SQLite::Database& sqlite, const std::string& study);
std::optional<StudyEntry> study_in(SQLite::Database& sqlite, const std::string& name);

// Replaces a study of the same name.
void write_study(SQLite::Database& sqlite, const StudyEntry& study);

// Begins a session; returns its number.
std::int64_t write_session(SQLite::Database& sqlite, const std::map<std::string, std::string>& environment);

// Writes facts of a session, which must not have these keys yet.
void write_environment(SQLite::Database& sqlite, std::int64_t session,
                       const std::map<std::string, std::string>& environment);

void write_solves(SQLite::Database& sqlite, const std::vector<SolveRecord>& records);

}  // namespace ikbench::results
