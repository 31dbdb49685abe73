// The digests of studies and sessions, in the table `meta`, and what does not fit them. All is done within the caller's
// transaction.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
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

// The rows of `meta`, in `main` or in another database that is attached.
std::map<std::string, std::string> meta_in(SQLite::Database& sqlite, const std::string& database = "main");

// Of a study in the place of another. What did not fit before does not fit then.
void write_digest(SQLite::Database& sqlite, const StudyEntry& study, const std::optional<StudyEntry>& before);
// A row of `meta` (looks.hpp), unless it is there.
void write_look(SQLite::Database& sqlite, const std::string& study, const std::string& key, const std::string& when);
void write_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& digest);
// A session whose digest was removed gets none.
void add_to_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& further);

std::set<std::int64_t> sessions_with_digest(SQLite::Database& sqlite, const std::string& database);

// The solves of each session.
using SolveSums = std::map<std::int64_t, SessionDigest>;

// Adds up the rows of `solves` that a statement passes.
class SolveAdder {
 public:
  explicit SolveAdder(SQLite::Statement& row);
  std::int64_t rowid() const { return row_.getColumn(rowid_).getInt64(); }
  void add_to(SolveSums& sums) const;

 private:
  SQLite::Statement& row_;
  int rowid_, session_, digest_, study_, series_, run_, point_;
};

// Solves that were read whole: of some series, the rows before one.
struct Summed {
  std::int64_t next_row = std::numeric_limits<std::int64_t>::min();
  std::map<std::string, SolveSums> of_series = {};
};

// What a store says of itself at one moment.
struct Written {
  std::vector<StudyEntry> studies;
  std::vector<Session> sessions;
  std::map<std::string, std::string> meta;
  std::int64_t last_row;  // of `solves`
};
Written written_in(SQLite::Database& sqlite);  // `meta` and last row

// Of all solves, but those that came after `last_row`. What is not known is read some at a time, as who writes to a
// store without a log waits for the end of a query.
SolveSums summed_solves(SQLite::Database& sqlite, std::int64_t last_row, const Summed& known = {});

// What does not fit: of the studies, and of all sessions but those of other studies.
Changes changes_since(SQLite::Database& sqlite, const Written& written, const Summed& known);

}  // namespace ikbench::results
