// The store: one SQLite file that remembers studies, sessions and solves. Several studies may share a store.
// Schema: docs/data-dictionary.md. A user's mistake (no such file, not a store, damaged, another schema, no permission,
// a study of too many solves, two processes at one study) is std::invalid_argument; a store kept locked by another
// process or taken away while it is written, or a full disk std::runtime_error; a mistake of ours (a definition that is
// not JSON) std::logic_error. The file may be anybody's: whatever in it ikbench would not have written is damage, and
// no SQL of it is run. A Store belongs to one thread at a time.
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

// One solver as it takes part in a study.
struct Series {
  std::string key;        // of everything that decides its numbers (record.hpp)
  std::string label;      // its name in tables and figures, unique within the study
  std::string algorithm;  // registered name of the solver
  std::string options;    // JSON object with every option value
};

// Of solves from a file: nothing here makes them.
constexpr std::string_view imported_algorithm = "imported";
inline bool is_imported(const Series& series) { return series.algorithm == imported_algorithm; }

// A study as it was defined when it was last run.
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

// A store that a kill left in the middle of a transaction, or of being made: it is whole again when whoever may write
// to it opens it to write.
struct HalfWritten : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// What in a store is not as it was written (digest.hpp).
struct Changes {
  std::vector<std::string> sentences = {};
  bool are_known = true;  // false: some of its digests were removed, so that no change shows
};

class Store {
 public:
  // write creates the file and its folders where missing; write_shared does it in a folder that several machines see,
  // without a write-ahead log (store_file.hpp).
  enum class Mode { read, write, write_shared };

  Store(const std::filesystem::path& file, Mode mode);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;

  const std::string& name() const;  // of the file, as it was given

  // Writes the study; one of the same name is replaced (its solves stay; only those of the new series are current).
  void save_study(const StudyEntry& study);
  std::vector<StudyEntry> studies() const;          // in the order they were first saved
  StudyEntry study(const std::string& name) const;  // std::invalid_argument where there is none

  std::int64_t begin_session(const std::map<std::string, std::string>& environment);
  // What is known of a session at its end; it has none of these keys yet.
  void add_to_session(std::int64_t id, const std::map<std::string, std::string>& environment);
  std::vector<Session> sessions() const;

  // All of them in one transaction, which outlives the process, however that ends. A solve that is already there
  // (series, run, point), because another process solves the same, is std::invalid_argument; then none of them is kept.
  // Each gets its digest, whatever it had.
  void append(const std::vector<SolveRecord>& records);

  // The end of writing: makes the store one plain file, and waits some seconds for others who have it open. Gives the
  // files that hold it, which are to be copied together: the store, and its log where that is still needed.
  // std::runtime_error where the store is no longer in its place.
  std::vector<std::filesystem::path> finish();

  // What `action` reads of the store is of one moment, whatever others write meanwhile.
  void at_one_moment(const std::function<void()>& action) const;
  // Calls `take` with every solve of one series, ordered by run and point. Who writes meanwhile does not wait for the
  // end, and what it adds may be among them.
  void each_of_series(const std::string& key, const std::function<void(SolveRecord)>& take) const;
  // The same, but only run and point.
  void each_place(const std::string& key, const std::function<void(int run, int point)>& take) const;
  // The sessions that made solves of these series, in the order of their numbers.
  std::vector<std::int64_t> sessions_of(const std::vector<Series>& series) const;
  // How many solves each series of a configuration has, by its key: one series for every source that solved it.
  std::map<std::string, std::int64_t> series_of_configuration(std::string_view configuration) const;
  // Calls `take` with every current solve of a study, in the order of its series, then run, then point; runs and
  // points beyond `runs` and `points` of the definition are left out. The solver of each is the label of its series.
  void each_of_study(const StudyEntry& study, const std::function<void(SolveRecord)>& take) const;
  // All of these at once, for a study that is small, or not walked in this order.
  std::vector<SolveRecord> solves(const std::string& study) const;
  // Of these studies, and of the sessions that solved for them. What is in a solve, its own digest shows.
  Changes changes(const std::vector<std::string>& studies) const;
  // How many solves these series have, of any run.
  std::int64_t solves_of(const std::vector<Series>& series) const;

 private:
  struct Database;
  std::unique_ptr<Database> database_;
};

}  // namespace ikbench::results
