// The store: one SQLite file of studies, sessions and solves. Several studies may share a store. Schema:
// docs/reference/data.md.
// std::invalid_argument means a user's mistake: no such file, not a store, damaged, another version, no permission, two
// processes at one study. std::runtime_error means a full disk, or a store that another process keeps locked or takes
// away.
// Opening a store checks its file (PRAGMA quick_check). A Store belongs to one thread at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "results/record.hpp"
#include "results/study.hpp"

namespace SQLite {
class Database;
}

namespace ikbench::results {

// One solver's part in a study.
struct Series {
  std::string key;        // of everything that decides its numbers (record.hpp)
  std::string label;      // its name in tables and figures, unique within the study
  std::string algorithm;  // registered name of the solver
  std::string options;    // JSON object with every option value
};

// A study as defined at its last run.
struct StoredStudy {
  std::string name;
  Definition definition;
  std::vector<Series> series;  // in the order of the study
};

struct Session {
  std::int64_t id = 0;
  std::string began = {};                               // date and time, UTC
  std::map<std::string, std::string> environment = {};  // cpu, compiler, flags, commit, date, jobs, ...
};

// A store that a kill left in the middle of a transaction or of its creation. Opening it for writing mends it.
struct HalfWritten : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

class Store {
 public:
  // write creates the file and its folders if they are missing. While it lives, a write-ahead log stands beside the
  // file (https://www.sqlite.org/wal.html): a killed process loses nothing that was committed, and a transaction costs
  // no wait for the disk. The last writer folds the log in. All users of a log must be on one machine: write_shared,
  // for a folder that several machines see, has a rollback journal instead, during a transaction only.
  enum class Mode { read, write, write_shared };

  Store(const std::filesystem::path& file, Mode mode);
  ~Store();

  // Writes the study and replaces one of the same name (its solves stay; only those of the new series are current).
  void save_study(const StoredStudy& study);
  // Those of this name, one or none; "": all, in the order of their first save.
  std::vector<StoredStudy> studies(const std::string& name = "") const;
  // "": the first. std::invalid_argument if there is none. No other's definition is read.
  StoredStudy study(const std::string& name) const;

  std::int64_t begin_session(const std::map<std::string, std::string>& environment);
  // Adds facts that are known at a session's end; it must not have these keys yet.
  void add_to_session(std::int64_t id, const std::map<std::string, std::string>& environment);
  std::vector<Session> sessions() const;

  // Adds all of them in one transaction, which survives any end of the process. Throws std::invalid_argument, and adds
  // none, if one (series, run, point) is there already because another process solves the same.
  void append(const std::vector<SolveRecord>& records);

  // Ends writing: makes the store one plain file, and waits some seconds for others who have it open. Returns the files
  // that hold it and must be copied together: the store, and its log if that is still needed. Throws std::runtime_error
  // if the store is no longer in its place.
  std::vector<std::filesystem::path> finish();

  // Lets `action` write by SQL, in one transaction, in which `source` has the tables of another store. For a merge.
  void write_from(const std::filesystem::path& source, const std::function<void(SQLite::Database&)>& action);

  // Passes on every value of every row of every table as bytes, in an order that depends on the rows alone, but for the
  // facts of sessions of this name.
  void each_value(std::string_view left_out, const std::function<void(std::string_view bytes)>& take) const;

  // Lets `action` read the store as of one moment, whatever others write meanwhile.
  void at_one_moment(const std::function<void()>& action) const;
  // May move from the record, or change it.
  using Take = std::function<void(SolveRecord&)>;
  // Calls `take` with every solve of one series, ordered by run and point.
  void each_of_series(const std::string& key, const Take& take) const;
  std::vector<std::string> names_of_extras(const StoredStudy& study) const;  // of solves of its series, sorted
  // The number of solves that other sources made of the configuration of a series.
  std::int64_t solves_of_other_sources(std::string_view series) const;
  // The current solves of a study are those of its series, without runs and points beyond those of the definition.
  // Calls `take` with each, in the order of its series, then run, then point. The solver of each is the label of its
  // series.
  void each_of_study(const StoredStudy& study, const Take& take) const;
  // All of these at once, for a small study, or one that is not walked in this order.
  std::vector<SolveRecord> solves(const std::string& study) const;
  std::int64_t number_of_solves(const StoredStudy& study) const;

 private:
  struct Database;
  std::unique_ptr<Database> database_;
};

}  // namespace ikbench::results
