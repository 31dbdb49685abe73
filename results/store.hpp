// The store: one SQLite file of studies, sessions and solves. Several studies may share a store. Schema:
// docs/data-dictionary.md.
// std::invalid_argument means a user's mistake: no such file, not a store, damaged, another version, no permission, a
// study of too many solves, two processes at one study. std::runtime_error means a full disk, or a store that another
// process keeps locked or takes away.
// Opening a store checks its file (PRAGMA quick_check); no SQL of the file is run. A Store belongs to one thread at a
// time.
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

namespace ikbench::results {

// One solver's part in a study.
struct Series {
  std::string key;        // of everything that decides its numbers (record.hpp)
  std::string label;      // its name in tables and figures, unique within the study
  std::string algorithm;  // registered name of the solver
  std::string options;    // JSON object with every option value
};

// A study as defined at its last run.
struct StudyEntry {
  std::string name;
  std::string definition;  // JSON object: robot, path, search, bounds, population, stop rule, runs, points, seed, ...
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

// Looks at a solve that is read; throws what is wrong with it.
using SolveCheck = std::function<void(const SolveRecord&)>;

class Store {
 public:
  // write creates the file and its folders if they are missing; write_shared does so in a folder that several machines
  // see, without a write-ahead log (store_file.hpp).
  enum class Mode { read, write, write_shared };

  Store(const std::filesystem::path& file, Mode mode);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;

  // Writes the study and replaces one of the same name (its solves stay; only those of the new series are current).
  void save_study(const StudyEntry& study);
  std::vector<StudyEntry> studies() const;          // in the order of their first save
  StudyEntry study(const std::string& name) const;  // std::invalid_argument if there is none

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

  // Lets `action` read the store as of one moment, whatever others write meanwhile.
  void at_one_moment(const std::function<void()>& action) const;
  // Calls `take` with every solve of one series, ordered by run and point. Writers do not wait for its end, and what
  // they add may be among them.
  void each_of_series(const std::string& key, const std::function<void(SolveRecord)>& take) const;
  // The same, but with run and point only.
  void each_place(const std::string& key, const std::function<void(int run, int point)>& take) const;
  // The number of solves of each series of a configuration, by its key: one series for every source that solved it.
  std::map<std::string, std::int64_t> series_of_configuration(std::string_view configuration) const;
  // Calls `take` with every current solve of a study, in the order of its series, then run, then point, without runs
  // and points beyond those of the definition. The solver of each is the label of its series.
  void each_of_study(const StudyEntry& study, const std::function<void(SolveRecord)>& take) const;
  // All of these at once, for a small study, or one that is not walked in this order.
  std::vector<SolveRecord> solves(const std::string& study) const;
  // From now on each solve that each_of_study() reads is checked first, by what `make` returns for its study.
  void check_solves(std::function<SolveCheck(const StudyEntry&)> make);
  // The number of solves of these series, of any run.
  std::int64_t solves_of(const std::vector<Series>& series) const;

 private:
  struct Database;
  std::unique_ptr<Database> database_;
  std::function<SolveCheck(const StudyEntry&)> check_of_;  // may be empty
};

}  // namespace ikbench::results
