#include "results/store_tables.hpp"

#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "results/store_codec.hpp"
#include "results/store_digests.hpp"

namespace ikbench::results {

std::vector<Series> series_in(SQLite::Database& sqlite, const std::string& study) {
  SQLite::Statement query(
      sqlite, "SELECT key, label, algorithm, options, position FROM series WHERE study = ? ORDER BY position LIMIT ?");
  SQLite::bind(query, study, static_cast<std::int64_t>(most_series) + 1);  // one too many is enough to refuse it
  std::vector<Series> list;
  while (query.executeStep()) {
    value_in<std::int64_t>(query.getColumn(4));
    list.push_back({.key = value_in<std::string>(query.getColumn(0)),
                    .label = value_in<std::string>(query.getColumn(1)),
                    .algorithm = value_in<std::string>(query.getColumn(2)),
                    .options = value_in<std::string>(query.getColumn(3))});
  }
  return list;
}

std::optional<StudyEntry> study_in(SQLite::Database& sqlite, const std::string& name) {
  SQLite::Statement query(sqlite, "SELECT definition FROM studies WHERE name = ?");
  query.bind(1, name);
  if (!query.executeStep()) return std::nullopt;
  return StudyEntry{
      .name = name, .definition = value_in<std::string>(query.getColumn(0)), .series = series_in(sqlite, name)};
}

void write_study(SQLite::Database& sqlite, const StudyEntry& study) {
  write_digest(sqlite, study, study_in(sqlite, study.name));
  SQLite::Statement save(sqlite,
                         "INSERT INTO studies (name, definition, saved) "
                         "VALUES (?1, ?2, strftime('%Y-%m-%dT%H:%M:%SZ', 'now')) "
                         "ON CONFLICT (name) DO UPDATE SET definition = excluded.definition, saved = excluded.saved");
  SQLite::bind(save, study.name, study.definition);
  save.exec();
  SQLite::Statement clear(sqlite, "DELETE FROM series WHERE study = ?");
  clear.bind(1, study.name);
  clear.exec();
  SQLite::Statement add(
      sqlite, "INSERT INTO series (study, position, key, label, algorithm, options) VALUES (?, ?, ?, ?, ?, ?)");
  std::int64_t position = 0;
  for (const Series& series : study.series) {
    SQLite::bind(add, study.name, ++position, series.key, series.label, series.algorithm, series.options);
    add.exec();
    add.reset();
  }
}

std::int64_t write_session(SQLite::Database& sqlite, const std::map<std::string, std::string>& environment) {
  sqlite.exec("INSERT INTO sessions (began) VALUES (strftime('%Y-%m-%dT%H:%M:%SZ', 'now'))");
  const std::int64_t id = sqlite.getLastInsertRowid();
  write_environment(sqlite, id, environment);
  const std::string began = sqlite.execAndGet(fmt::format("SELECT began FROM sessions WHERE id = {}", id)).getString();
  write_digest(sqlite, id, {.sum = digest_of({.id = id, .began = began, .environment = environment})});
  return id;
}

void write_environment(SQLite::Database& sqlite, std::int64_t session,
                       const std::map<std::string, std::string>& environment) {
  SQLite::Statement add(sqlite, "INSERT INTO environment (session, key, value) VALUES (?, ?, ?)");
  for (const auto& [key, value] : environment) {
    SQLite::bind(add, session, key, value);
    add.exec();
    add.reset();
  }
}

void write_solves(SQLite::Database& sqlite, const std::vector<SolveRecord>& records) {
  SQLite::Statement insert(sqlite, insert_solve());
  std::map<std::int64_t, SessionDigest> of_sessions;
  for (SolveRecord record : records) {
    record.digest = digest_of(record);
    bind_solve(insert, record);
    insert.exec();
    insert.reset();
    SessionDigest& sum = of_sessions[record.session];
    ++sum.solves;
    sum.sum += record.digest + digest_of_place(record.study, record.series, record.run, record.point);
  }
  for (const auto& [session, sum] : of_sessions) add_to_digest(sqlite, session, sum);
}

}  // namespace ikbench::results
