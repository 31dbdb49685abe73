// A hand-made study, read from a store.
#pragma once

#include "analysis/judge/data/study_results.hpp"
#include "tests/common.hpp"

namespace ikbench::judge {

// Records without a series are of the series with their solver's label. One store has all studies of a program, because
// making one waits for the disk, and a session once, because each study reads them all.
inline StudyResults to_stored(results::StoredStudy entry, std::vector<results::SolveRecord> solves,
                              const std::vector<results::Session>& sessions = {}) {
  static const ScratchFolder folder;
  static results::Store store(folder.path / "store.sqlite", results::Store::Mode::write);
  static int studies = 0;
  static std::map<std::pair<std::int64_t, decltype(results::Session::environment)>, std::int64_t> begun;
  const std::string own = fmt::format("{} ", ++studies);
  std::map<std::int64_t, std::int64_t> stored;
  for (const results::Session& session : sessions) {
    std::int64_t& id = begun[{session.id, session.environment}];
    if (id == 0) id = store.begin_session(session.environment);
    stored[session.id] = id;
  }
  for (results::SolveRecord& solve : solves) {
    if (solve.series.empty()) solve.series = std::ranges::find(entry.series, solve.label, &results::Series::label)->key;
    solve.series.insert(0, own);
    solve.session = stored[solve.session];
  }
  for (results::Series& series : entry.series) series.key.insert(0, own);
  store.append(solves);
  return read_study(store, entry);
}

}  // namespace ikbench::judge
