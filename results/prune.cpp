#include "results/prune.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "results/store_digests.hpp"
#include "results/store_file.hpp"

namespace ikbench::results {
namespace {

constexpr const char* unused_solves = "FROM solves WHERE series NOT IN (SELECT key FROM series)";
constexpr const char* unused_sessions =
    "FROM sessions WHERE id NOT IN (SELECT session FROM solves WHERE series IN (SELECT key FROM series))";

Unused unused_in(StoreFile& file) {
  file.refuse_blobs("solves", "series");
  file.refuse_blobs("series", "key");
  return {.solves = file.number(fmt::format("SELECT count(*) {}", unused_solves).c_str()),
          .sessions = file.number(fmt::format("SELECT count(*) {}", unused_sessions).c_str())};
}

void refuse_changed(const Store& store) {
  std::vector<std::string> names;
  for (const StudyEntry& study : store.studies()) names.push_back(study.name);
  const std::vector<std::string> changes = store.changes(names).sentences;
  if (changes.empty()) return;
  throw std::invalid_argument(
      fmt::format("'{}' was changed since it was written: {}; nothing was removed", store.name(), changes.front()));
}

void remove_study(SQLite::Database& sqlite, const std::string& study) {
  erase_digest(sqlite, study);
  for (const char* rows : {"DELETE FROM series WHERE study = ?", "DELETE FROM studies WHERE name = ?"}) {
    SQLite::Statement remove(sqlite, rows);
    remove.bind(1, study);
    remove.exec();
  }
}

}  // namespace

Unused unused_in(const std::filesystem::path& store) {
  return guarded(store.string(), [&] {
    StoreFile file(store, Store::Mode::read);
    return unused_in(file);
  });
}

Unused prune(const std::filesystem::path& store, const std::string& study) {
  std::vector<Session> sessions;
  {
    const Store before(store, Store::Mode::read);
    if (!study.empty()) static_cast<void>(before.study(study));
    refuse_changed(before);
    sessions = before.sessions();
  }
  return guarded(store.string(), [&] {
    StoreFile file(store, Store::Mode::write);
    SQLite::Database& sqlite = file.sqlite();
    // This needs the file alone: SQLite refuses it while a run has the store open.
    if (sqlite.execAndGet("PRAGMA journal_mode = DELETE").getString() != "delete")
      throw std::runtime_error(
          fmt::format("'{}' is in use; wait until the run that writes it has ended", store.string()));
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    if (!study.empty()) remove_study(sqlite, study);
    const Unused unused = unused_in(file);
    const auto is_left = [&](const Session& session) {
      SQLite::Statement query(sqlite, fmt::format("SELECT 1 {} AND id = ?", unused_sessions));
      query.bind(1, session.id);
      return !query.executeStep();
    };
    std::erase_if(sessions, [&](const Session& session) {
      if (is_left(session)) return false;
      erase_digest(sqlite, session.id);
      return true;
    });
    sqlite.exec(fmt::format("DELETE FROM environment WHERE session IN (SELECT id {})", unused_sessions));
    sqlite.exec(fmt::format("DELETE {}", unused_sessions));
    sqlite.exec(fmt::format("DELETE {}", unused_solves));
    SolveSums sums = summed_solves(sqlite, std::numeric_limits<std::int64_t>::max());
    const std::set<std::int64_t> with_digest = sessions_with_digest(sqlite, "main");
    for (const Session& session : sessions) {
      if (!with_digest.contains(session.id)) continue;
      SessionDigest& digest = sums[session.id];
      digest.sum += digest_of(session);
      write_digest(sqlite, session.id, digest);
    }
    file.commit(transaction);
    sqlite.exec("VACUUM");
    file.finish();
    return unused;
  });
}

}  // namespace ikbench::results
