#include "results/store_tables.hpp"

#include <SQLiteCpp/VariadicBind.h>

namespace ikbench::results {

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

void write_environment(SQLite::Database& sqlite, std::int64_t session,
                       const std::map<std::string, std::string>& environment) {
  SQLite::Statement add(sqlite, "INSERT INTO environment (session, key, value) VALUES (?, ?, ?)");
  for (const auto& [key, value] : environment) {
    SQLite::bind(add, session, key, value);
    add.exec();
    add.reset();
  }
}

}  // namespace ikbench::results
