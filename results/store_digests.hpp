// The digests of studies and sessions, in the table `meta`, and what does not fit them. All is done within the caller's
// transaction.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "results/digest.hpp"
#include "results/store.hpp"

namespace ikbench::results {

// How many solves a session made, and the sum of its own digest and of theirs and of their places.
struct SessionDigest {
  std::int64_t solves = 0;
  std::int64_t sum = 0;
  bool has_digests = false;  // whether a solve has one
};

void write_digest(SQLite::Database& sqlite, const StudyEntry& study);
void write_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& digest);
// A session that has no digest, because an older program began it, gets none.
void add_to_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& further);

// Which sessions have one, in `main` or in another database that is attached.
std::set<std::int64_t> sessions_with_digest(SQLite::Database& sqlite, const std::string& database);

// What a store says of itself at one moment.
struct Written {
  std::vector<StudyEntry> studies;
  std::vector<Session> sessions;
  std::map<std::string, std::string> digests;  // the rows of `meta`
  std::int64_t last_row;                       // of `solves`
};
Written written_in(SQLite::Database& sqlite);  // digests and last row

// The solves of each session. They are read some at a time, as who writes to a store without a log waits for the end of
// a query; those that came after `last_row` are left out.
std::map<std::int64_t, SessionDigest> summed_solves(SQLite::Database& sqlite, std::int64_t last_row);

// What does not fit: of the studies, and of all sessions but those of other studies.
Changes changes_since(SQLite::Database& sqlite, const Written& written);

}  // namespace ikbench::results
