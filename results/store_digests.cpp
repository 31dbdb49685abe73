#include "results/store_digests.hpp"

#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "numerics/number.hpp"
#include "results/looks.hpp"
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

// Adds to a row of `meta`; returns the number of rows changed.
int add(SQLite::Database& sqlite, const std::string& key, std::int64_t number) {
  SQLite::Statement add(sqlite, "UPDATE meta SET value = value + ? WHERE key = ?");
  SQLite::bind(add, number, key);
  return add.exec();
}

void erase(SQLite::Database& sqlite, const std::string& key) {
  SQLite::Statement remove(sqlite, "DELETE FROM meta WHERE key = ?");
  remove.bind(1, key);
  remove.exec();
}

// Says why a session does not fit its digest; empty if it fits.
std::string change_of(const Written& written, const Session& session, const SessionDigest& solves) {
  const auto digest = written.meta.find(digest_key(session.id));
  const auto number = written.meta.find(solves_key(session.id));
  if (digest == written.meta.end())
    return solves.has_digests ? "it has lost its digest, which its solves still have" : "";
  if (number == written.meta.end()) return "it has lost the number of its solves";
  if (number->second != std::to_string(solves.solves))
    return fmt::format("it has {} solves, and {} were stored", solves.solves, excerpt(number->second));
  const bool fits = digest->second == std::to_string(solves.sum + digest_of(session));
  return fits ? "" : "what is known of it, or its solves, are not what was stored";
}

// True unless the session says that it solved another study of the store.
bool may_be_of(const Session& session, const Written& written) {
  const auto study = session.environment.find("study");
  if (study == session.environment.end()) return true;
  return std::ranges::find(written.studies, study->second, &StudyEntry::name) != written.studies.end() ||
         !written.meta.contains(digest_key(StudyEntry{.name = study->second}));
}

constexpr std::string_view select_places = "SELECT rowid, session, digest, study, series, run, point FROM solves ";
constexpr int at_once = 10'000;
constexpr std::int64_t before_all = std::numeric_limits<std::int64_t>::min();

// Adds the rows from `first` to `last`, both included.
void add_rows(SQLite::Database& sqlite, std::int64_t first, std::int64_t last, SolveSums& sums) {
  SQLite::Statement query(sqlite, fmt::format("{} WHERE rowid BETWEEN ? AND ? ORDER BY rowid LIMIT ?", select_places));
  const SolveAdder row(query);
  for (int read = at_once; read == at_once; query.reset()) {
    SQLite::bind(query, first, last, at_once);
    for (read = 0; query.executeStep(); ++read) {
      row.add_to(sums);
      if (row.rowid() == last) return;
      first = row.rowid() + 1;
    }
  }
}

// Adds the rows of a series before a rowid.
void add_series(SQLite::Database& sqlite, const std::string& series, std::int64_t next_row, SolveSums& sums) {
  SQLite::Statement query(
      sqlite, fmt::format("{} WHERE series = ? AND (run, point) > (?, ?) AND rowid < ? ORDER BY run, point LIMIT ?",
                          select_places));
  const SolveAdder row(query);
  std::int64_t run = before_all, point = before_all;
  for (int read = at_once; read == at_once; query.reset()) {
    SQLite::bind(query, series, run, point, next_row, at_once);
    for (read = 0; query.executeStep(); ++read) {
      row.add_to(sums);
      run = query.getColumn("run").getInt64();
      point = query.getColumn("point").getInt64();
    }
  }
}

// The series of all solves. Each look-up starts after the previous one.
std::vector<std::string> series_of_solves(SQLite::Database& sqlite) {
  std::vector<std::string> all;
  SQLite::Statement first(sqlite, "SELECT min(series) FROM solves"),
      next(sqlite, "SELECT min(series) FROM solves WHERE series > ?");
  for (SQLite::Statement* query = &first; query->executeStep() && !query->getColumn(0).isNull(); query = &next) {
    all.push_back(value_in<std::string>(query->getColumn(0)));
    next.reset();
    next.bind(1, all.back());
  }
  return all;
}

}  // namespace

std::map<std::string, std::string> meta_in(SQLite::Database& sqlite, const std::string& database) {
  SQLite::Statement query(sqlite, fmt::format("SELECT key, value FROM {}.meta", database));
  std::map<std::string, std::string> meta;
  while (query.executeStep())
    meta[value_in<std::string>(query.getColumn(0))] = value_in<std::string>(query.getColumn(1));
  return meta;
}

void write_digest(SQLite::Database& sqlite, const StudyEntry& study, const std::optional<StudyEntry>& before) {
  if (before) {  // a removed digest does not come back
    add(sqlite, digest_key(study), digest_of(study) - digest_of(*before));
    return;
  }
  note(sqlite, digest_key(study), digest_of(study) + digest_of(looks_among(meta_in(sqlite), study.name)));
}

void write_look(SQLite::Database& sqlite, const std::string& study, const std::string& key, const std::string& when) {
  SQLite::Statement insert(sqlite, "INSERT OR IGNORE INTO meta (key, value) VALUES (?, ?)");
  SQLite::bind(insert, key, when);
  if (insert.exec() == 0) return;
  add(sqlite, digest_key(StudyEntry{.name = study}), digest_of(std::map<std::string, std::string>{{key, when}}));
}

void write_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& digest) {
  note(sqlite, solves_key(session), digest.solves);
  note(sqlite, digest_key(session), digest.sum);
}

void add_to_digest(SQLite::Database& sqlite, std::int64_t session, const SessionDigest& further) {
  add(sqlite, solves_key(session), further.solves);
  add(sqlite, digest_key(session), further.sum);
}

void erase_digest(SQLite::Database& sqlite, const std::string& study) {
  erase(sqlite, digest_key(StudyEntry{.name = study}));
  for (const auto& [key, when] : looks_among(meta_in(sqlite), study)) erase(sqlite, key);
}

void erase_digest(SQLite::Database& sqlite, std::int64_t session) {
  erase(sqlite, digest_key(session));
  erase(sqlite, solves_key(session));
}

std::set<std::int64_t> sessions_with_digest(SQLite::Database& sqlite, const std::string& database) {
  std::set<std::int64_t> sessions;
  for (const auto& [key, value] : meta_in(sqlite, database)) {
    if (!key.starts_with(of_session)) continue;
    if (const auto number = numerics::number_from(key.substr(of_session.size())))
      sessions.insert(static_cast<std::int64_t>(*number));
  }
  return sessions;
}

SolveAdder::SolveAdder(SQLite::Statement& row)
    : row_(row),
      rowid_(row.getColumnIndex("rowid")),
      session_(row.getColumnIndex("session")),
      digest_(row.getColumnIndex("digest")),
      study_(row.getColumnIndex("study")),
      series_(row.getColumnIndex("series")),
      run_(row.getColumnIndex("run")),
      point_(row.getColumnIndex("point")) {}

void SolveAdder::add_to(SolveSums& sums) const {
  const auto digest = value_in<std::int64_t>(row_.getColumn(digest_));
  if (!std::in_range<std::uint32_t>(digest)) throw Damage(fmt::format("digest {} of a solve", digest));
  SessionDigest& sum = sums[value_in<std::int64_t>(row_.getColumn(session_))];
  ++sum.solves;
  sum.has_digests = sum.has_digests || digest != 0;
  sum.sum += digest + digest_of_place(
                          value_in<std::string>(row_.getColumn(study_)), value_in<std::string>(row_.getColumn(series_)),
                          value_in<std::int64_t>(row_.getColumn(run_)), value_in<std::int64_t>(row_.getColumn(point_)));
}

Written written_in(SQLite::Database& sqlite) {
  return {.studies = {},
          .sessions = {},
          .meta = meta_in(sqlite),
          .last_row = sqlite.execAndGet("SELECT coalesce(max(rowid), 0) FROM solves").getInt64()};
}

SolveSums summed_solves(SQLite::Database& sqlite, std::int64_t last_row, const Summed& known) {
  SolveSums sums;
  for (const auto& [series, of_series] : known.of_series) {
    for (const auto& [session, sum] : of_series) {
      sums[session].solves += sum.solves;
      sums[session].sum += sum.sum;
      sums[session].has_digests |= sum.has_digests;
    }
  }
  if (known.of_series.empty()) {
    add_rows(sqlite, before_all, last_row, sums);
    return sums;
  }
  for (const std::string& series : series_of_solves(sqlite)) {
    if (!known.of_series.contains(series)) add_series(sqlite, series, known.next_row, sums);
  }
  add_rows(sqlite, known.next_row, last_row, sums);
  return sums;
}

Changes changes_since(SQLite::Database& sqlite, const Written& written, const Summed& known) {
  Changes changes;
  const std::string of_study = digest_key(StudyEntry{});
  for (const auto& [key, value] : written.meta) {
    if (!key.starts_with(of_study)) continue;
    const std::string name = key.substr(of_study.size());
    SQLite::Statement named(sqlite, "SELECT 1 FROM studies WHERE name = ?");
    named.bind(1, name);
    if (named.executeStep()) continue;
    changes.sentences.push_back(fmt::format("study {} has a digest, but the store has no such study", excerpt(name)));
  }
  for (const StudyEntry& study : written.studies) {
    const auto digest = written.meta.find(digest_key(study));
    const bool is_known = digest != written.meta.end();
    const bool has_sessions = std::ranges::any_of(written.sessions, [&](const Session& session) {
      return may_be_of(session, written) && written.meta.contains(digest_key(session.id));
    });
    changes.are_known = changes.are_known && is_known;
    if (!is_known && has_sessions && written.studies.size() == 1)
      changes.sentences.push_back(
          fmt::format("study {} has no digest, though its sessions have one", excerpt(study.name)));
    const std::int64_t expected = digest_of(study) + digest_of(looks_among(written.meta, study.name));
    if (is_known && digest->second != std::to_string(expected))
      changes.sentences.push_back(
          fmt::format("the definition of study {}, its series or its looks were changed since they were written",
                      excerpt(study.name)));
  }
  SolveSums sums = summed_solves(sqlite, written.last_row, known);
  for (const Session& session : written.sessions) {
    if (!may_be_of(session, written)) continue;
    changes.are_known = changes.are_known && written.meta.contains(digest_key(session.id));
    const std::string change = change_of(written, session, sums[session.id]);
    if (!change.empty())
      changes.sentences.push_back(fmt::format("session {} of {} was changed since it was written: {}", session.id,
                                              excerpt(session.began), change));
  }
  return changes;
}

}  // namespace ikbench::results
