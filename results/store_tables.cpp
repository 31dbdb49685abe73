#include "results/store_tables.hpp"

#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "numerics/json.hpp"
#include "results/store_codec.hpp"

namespace ikbench::results {

Last last_of(const StudyEntry& study) {
  const auto definition = numerics::parsed_json(study.definition);
  const auto number = [&](const char* key, std::int64_t otherwise) {
    const bool is_number = definition.contains(key) && definition[key].is_number_integer();
    return is_number ? definition[key].get<std::int64_t>() : otherwise;
  };
  const Last last{.run = number("runs", 0), .point = number("points", no_end)};
  if (last.run < 1) throw Damage(fmt::format("the definition of study {} has no runs", excerpt(study.name)));
  return last;
}

std::vector<Series> series_in(SQLite::Database& sqlite, const std::string& study) {
  SQLite::Statement query(sqlite,
                          "SELECT key, label, algorithm, options FROM series WHERE study = ? ORDER BY position");
  query.bind(1, study);
  std::vector<Series> list;
  while (query.executeStep()) {
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
  for (const SolveRecord& record : records) {
    bind_solve(insert, record);
    insert.exec();
    insert.reset();
  }
}

}  // namespace ikbench::results
