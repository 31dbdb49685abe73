// The store: one SQLite file of studies, sessions and solves. Several studies may share a store. It is the only way
// from the half that runs solvers to the half that judges them. Schema: docs/reference/data.md.
// std::invalid_argument means a mistake of the user: no such file, not a store, damaged, another version, no
// permission, two processes at one study. std::runtime_error means a full disk, or a store that another process keeps
// locked or takes away.
// Opening a store checks its whole file (PRAGMA quick_check), so it takes time in proportion to the file. A Store
// belongs to one thread at a time.
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

#include "results/counted_answers.hpp"
#include "results/record.hpp"
#include "results/study.hpp"

namespace SQLite {
class Database;
}

namespace ikbench::results {

// The solves of one solver entry of a study.
struct Series {
  std::string key;        // hash of everything that decides its numbers (record.hpp)
  std::string label;      // name in tables and figures, unique within the study
  std::string algorithm;  // registered name of the solver
  std::string options;    // JSON object with every option value
};

// A study as defined when it was last run.
struct StoredStudy {
  std::string name;
  StudyDefinition definition;
  std::vector<Series> series;  // in the order of the study
};

// One process start on one state of a machine; times are compared by session.
struct Session {
  std::int64_t id = 0;
  std::string began = {};                               // date and time, UTC
  std::map<std::string, std::string> environment = {};  // cpu, compiler, flags, commit, jobs, ...
};

// The error for a store that a kill left in the middle of a transaction or of its creation. Opening the store for
// writing mends it.
struct InterruptedWrite : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

class Store {
 public:
  // How the file is opened. `write` creates the file and its folders if they are missing. While the Store lives, a
  // write-ahead log stands beside the file (https://www.sqlite.org/wal.html): a killed process loses nothing that was
  // committed, and a transaction does not wait for the disk. The last writer folds the log in. All users of a log must
  // be on one machine. `write_shared` is for a folder that several machines see; it has a rollback journal instead,
  // during a transaction only.
  enum class Mode { read, write, write_shared };

  Store(const std::filesystem::path& file, Mode mode);
  ~Store();

  // Writes the study in place of one of the same name. Solves of the replaced study stay, but only those of the new
  // series are current.
  void save_study(const StoredStudy& study);
  // Writes the studies of one sweep in place of all studies that this sweep had. Their solves stay, and are current
  // again once a study with their series is saved.
  void save_sweep(const std::vector<StoredStudy>& studies);
  // Returns the studies of this name, one or none; for "" all, in the order of their first save.
  std::vector<StoredStudy> studies(const std::string& name = "") const;
  // Returns the study of this name, for "" the first. Throws std::invalid_argument if there is none. No other
  // definition is read.
  StoredStudy study(const std::string& name) const;
  // Returns the studies of the sweep with this name, for "" of the sweep that the first study is in, in the order of
  // the sweep. Empty if there is no such sweep.
  std::vector<StoredStudy> sweep(const std::string& name) const;

  // Writes the counts of a study's answers in place of earlier ones.
  void save_counted_answers(const std::string& study, const CountedAnswers& counted);
  // Returns the counts of a study's answers; empty if none were saved.
  CountedAnswers counted_answers(const std::string& study) const;

  // Adds a session with these facts and returns its number.
  std::int64_t begin_session(const std::map<std::string, std::string>& environment);
  // Adds facts that are known at the end of a session, which must not have these keys yet.
  void add_to_session(std::int64_t id, const std::map<std::string, std::string>& environment);
  std::vector<Session> sessions() const;

  // Appends all records in one transaction. Once it returns they survive any end of the process. If another process
  // stored one of the same (series, run, point), throws std::invalid_argument and adds none.
  void append(const std::vector<SolveRecord>& records);

  // Ends writing: makes the store one plain file, and waits some seconds for others who have it open. Returns the files
  // that have to be copied together: the store, and its log if that is still needed. Throws std::runtime_error if the
  // store is no longer in its place.
  std::vector<std::filesystem::path> close();

  // Lets `action` write by SQL in one transaction, in which `source` has the tables of another store. `merge` needs
  // this.
  void merge_from(const std::filesystem::path& source, const std::function<void(SQLite::Database&)>& action);

  // Passes every value of every row of every table to `take` as bytes. The order depends only on the rows. Facts of
  // sessions that are named `left_out` are skipped.
  void each_value(std::string_view left_out, const std::function<void(std::string_view bytes)>& take) const;

  // Lets `action` read the store as of one moment, whatever others write meanwhile.
  void in_snapshot(const std::function<void()>& action) const;
  // Receives a solve, and may move from the record or change it.
  using RecordConsumer = std::function<void(SolveRecord&)>;
  // Calls `take` with every solve of one series, ordered by run and point.
  void for_each_in_series(const std::string& key, const RecordConsumer& take) const;
  std::vector<std::string> extra_names(const StoredStudy& study) const;  // of the study's solves, sorted
  // Returns how many solves other sources made with the configuration of a series.
  std::int64_t stale_solve_count(std::string_view series) const;
  // Calls `take` with each current solve of a study, in the order of its series, then run, then point. Current are the
  // solves of the study's series, without runs and points beyond those of the definition. `label` of each solve is the
  // one of its series.
  void for_each_in_study(const StoredStudy& study, const RecordConsumer& take) const;
  std::int64_t solve_count(const StoredStudy& study) const;

 private:
  struct Database;
  std::unique_ptr<Database> database_;
};

}  // namespace ikbench::results
