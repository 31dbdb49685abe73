// The digests of studies and sessions in the table `meta`, and the checks against them. Everything happens within the
// caller's transaction.
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

// The number of a session's solves, and the sum of its own digest, theirs, and those of their places.
struct SessionDigest {
  std::int64_t solves = 0;
  std::int64_t sum = 0;
  bool has_digests = false;  // true if a solve has one
};

// The rows of `meta` in `main` or in an attached database.
std::map<std::string, std::string> meta_in(SQLite::Database& sqlite, const std::string& database = "main");

// Writes the digest of a study that replaces another. A digest that did not fit before does not fit afterwards.
void write_digest(SQLite::Database& sqlite, const StudyEntry& study, const std::optional<StudyEntry>& before);
// Writes a row of `meta` (looks.hpp), unless it exists.
void write_look(SQLite::Database& sqlite, const std::string& study, const std::string& key, const std::string& when);
void write_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& digest);
// Adds to a session's digest; one whose digest was removed gets none.
void add_to_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& further);

// Removes the digest of a study with its looks, or of a session.
void erase_digest(SQLite::Database& sqlite, const std::string& study);
void erase_digest(SQLite::Database& sqlite, std::int64_t session);

std::set<std::int64_t> sessions_with_digest(SQLite::Database& sqlite, const std::string& database);

// Sums over the solves of each session.
using SolveSums = std::map<std::int64_t, SessionDigest>;

// Adds up the rows of `solves` that a statement steps through.
class SolveAdder {
 public:
  explicit SolveAdder(SQLite::Statement& row);
  std::int64_t rowid() const { return row_.getColumn(rowid_).getInt64(); }
  void add_to(SolveSums& sums) const;

 private:
  SQLite::Statement& row_;
  int rowid_, session_, digest_, study_, series_, run_, point_;
};

// Sums over solves that were read completely: those of some series, in rows before `next_row`.
struct Summed {
  std::int64_t next_row = std::numeric_limits<std::int64_t>::min();
  std::map<std::string, SolveSums> of_series = {};
};

// A store's own account of itself at one moment.
struct Written {
  std::vector<StudyEntry> studies;
  std::vector<Session> sessions;
  std::map<std::string, std::string> meta;
  std::int64_t last_row;  // of `solves`
};
Written written_in(SQLite::Database& sqlite);  // reads `meta` and the last row only

// Sums over all solves up to `last_row`. Reads unknown ones some at a time, since a writer to a store without a log
// waits for the end of a query.
SolveSums summed_solves(SQLite::Database& sqlite, std::int64_t last_row, const Summed& known = {});

// The changes of the studies, and of all sessions except those of other studies.
Changes changes_since(SQLite::Database& sqlite, const Written& written, const Summed& known);

}  // namespace ikbench::results
