#include "results/store_digests.hpp"

#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "numerics/number.hpp"
#include "results/store_codec.hpp"

namespace ikbench::results {

namespace {

constexpr std::string_view of_session = "digest of session ";

std::string digest_key(std::int64_t session) { return fmt::format("{}{}", of_session, session); }
std::string digest_key(const StudyEntry& study) { return "digest of study " + study.name; }
std::string solves_key(std::int64_t session) { return fmt::format("solves of session {}", session); }

void note(SQLite::Database& sqlite, const std::string& key, std::int64_t number) {
  SQLite::Statement save(
      sqlite, "INSERT INTO meta (key, value) VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = excluded.value");
  SQLite::bind(save, key, std::to_string(number));
  save.exec();
}

// Why a session does not fit its digest; empty where it does.
std::string change_of(const Written& written, const Session& session, const SessionDigest& solves) {
  const auto digest = written.digests.find(digest_key(session.id));
  const auto number = written.digests.find(solves_key(session.id));
  if (digest == written.digests.end())
    return solves.has_digests ? "it has lost its digest, which its solves still have" : "";
  if (number == written.digests.end()) return "it has lost the number of its solves";
  if (number->second != std::to_string(solves.solves))
    return fmt::format("it has {} solves, and {} were stored", solves.solves, excerpt(number->second));
  const bool fits = digest->second == std::to_string(solves.sum + digest_of(session));
  return fits ? "" : "what is known of it, or its solves, are not what was stored";
}

// A session may be of any study, unless it says that it solved another one of the store.
bool may_be_of(const Session& session, const Written& written) {
  const auto study = session.environment.find("study");
  if (study == session.environment.end()) return true;
  return std::ranges::find(written.studies, study->second, &StudyEntry::name) != written.studies.end() ||
         !written.digests.contains(digest_key(StudyEntry{.name = study->second}));
}

}  // namespace

void write_digest(SQLite::Database& sqlite, const StudyEntry& study) {
  note(sqlite, digest_key(study), digest_of(study));
}

void write_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& digest) {
  note(sqlite, solves_key(session), digest.solves);
  note(sqlite, digest_key(session), digest.sum);
}

void add_to_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& further) {
  SQLite::Statement add(sqlite, "UPDATE meta SET value = value + ? WHERE key = ?");
  for (const auto& [key, number] :
       {std::pair(solves_key(session), further.solves), std::pair(digest_key(session), further.sum)}) {
    SQLite::bind(add, number, key);
    add.exec();
    add.reset();
  }
}

std::set<std::int64_t> sessions_with_digest(SQLite::Database& sqlite, const std::string& database) {
  SQLite::Statement query(sqlite, fmt::format("SELECT key FROM {}.meta WHERE key GLOB ?", database));
  query.bind(1, std::string(of_session) + '*');
  std::set<std::int64_t> sessions;
  while (query.executeStep()) {
    const auto key = value_in<std::string>(query.getColumn(0));
    if (const auto number = numerics::number_from(key.substr(of_session.size())))
      sessions.insert(static_cast<std::int64_t>(*number));
  }
  return sessions;
}

Written written_in(SQLite::Database& sqlite) {
  Written written{.last_row = sqlite.execAndGet("SELECT coalesce(max(rowid), 0) FROM solves").getInt64()};
  SQLite::Statement query(sqlite, "SELECT key, value FROM meta");
  while (query.executeStep())
    written.digests[value_in<std::string>(query.getColumn(0))] = value_in<std::string>(query.getColumn(1));
  return written;
}

std::map<std::int64_t, SessionDigest> summed_solves(SQLite::Database& sqlite, std::int64_t last_row) {
  constexpr int at_once = 10'000;
  SQLite::Statement query(sqlite,
                          "SELECT rowid, session, digest, series, run, point FROM solves WHERE rowid BETWEEN ? AND ? "
                          "ORDER BY rowid LIMIT ?");
  std::map<std::int64_t, SessionDigest> sums;
  std::int64_t first = std::numeric_limits<std::int64_t>::min();
  for (int read = at_once; read == at_once; query.reset()) {
    SQLite::bind(query, first, last_row, at_once);
    for (read = 0; query.executeStep(); ++read) {
      const auto digest = value_in<std::int64_t>(query.getColumn(2));
      if (!std::in_range<std::uint32_t>(digest)) throw Damage(fmt::format("digest {} of a solve", digest));
      SessionDigest& sum = sums[value_in<std::int64_t>(query.getColumn(1))];
      ++sum.solves;
      sum.has_digests = sum.has_digests || digest != 0;
      sum.sum += digest + digest_of_place(value_in<std::string>(query.getColumn(3)),
                                          value_in<std::int64_t>(query.getColumn(4)),
                                          value_in<std::int64_t>(query.getColumn(5)));
      const std::int64_t row = query.getColumn(0).getInt64();
      if (row == last_row) return sums;
      first = row + 1;
    }
  }
  return sums;
}

Changes changes_since(SQLite::Database& sqlite, const Written& written) {
  Changes changes;
  const std::vector<std::string_view> columns = column_names(sqlite.execAndGet("PRAGMA user_version").getInt64());
  if (std::ranges::find(columns, "digest") == columns.end()) return {.sentences = {}, .are_known = false};
  for (const StudyEntry& study : written.studies) {
    const auto digest = written.digests.find(digest_key(study));
    const bool is_known = digest != written.digests.end();
    const bool has_sessions = std::ranges::any_of(written.sessions, [&](const Session& session) {
      return may_be_of(session, written) && written.digests.contains(digest_key(session.id));
    });
    changes.are_known = changes.are_known && is_known;
    if (!is_known && has_sessions && written.studies.size() == 1)
      changes.sentences.push_back(
          fmt::format("study {} has no digest, though its sessions have one", excerpt(study.name)));
    if (digest != written.digests.end() && digest->second != std::to_string(digest_of(study)))
      changes.sentences.push_back(fmt::format(
          "the definition of study {} or its series were changed since they were written", excerpt(study.name)));
  }
  std::map<std::int64_t, SessionDigest> sums = summed_solves(sqlite, written.last_row);
  for (const Session& session : written.sessions) {
    if (!may_be_of(session, written)) continue;
    changes.are_known = changes.are_known && written.digests.contains(digest_key(session.id));
    const std::string change = change_of(written, session, sums[session.id]);
    if (!change.empty())
      changes.sentences.push_back(fmt::format("session {} of {} was changed since it was written: {}", session.id,
                                              excerpt(session.began), change));
  }
  return changes;
}

}  // namespace ikbench::results
