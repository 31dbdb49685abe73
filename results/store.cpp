// Reads and writes the studies, sessions and solves of a store.
#include "results/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "results/store_codec.hpp"
#include "results/store_file.hpp"
#include "results/store_tables.hpp"

namespace ikbench::results {
namespace {

// Refuses more solves than anybody can make.
void refuse_too_many(const StudyEntry& study) {
  constexpr double most = 1e8;
  const Last last = last_of(study);
  const std::int64_t points = last.point == no_end ? 1 : last.point;
  const double solves =
      static_cast<double>(last.run) * static_cast<double>(points) * static_cast<double>(study.series.size());
  if (solves > most)
    throw std::invalid_argument(
        fmt::format("study {} asks for {:.0f} solves ({} runs, {} points, {} series); expected at most {:.0f}",
                    excerpt(study.name), solves, last.run, points, study.series.size(), most));
}

}  // namespace

struct Store::Database : StoreFile {
  using StoreFile::StoreFile;

  // The names of the studies, for a sentence.
  std::string study_names() {
    constexpr std::int64_t most = 20;
    SQLite::Statement query(sqlite(), "SELECT name FROM studies ORDER BY position LIMIT ?");
    query.bind(1, most);
    std::vector<std::string> names;
    while (query.executeStep()) names.push_back(value_in<std::string>(query.getColumn(0)));
    const std::int64_t others = number("SELECT count(*) FROM studies") - static_cast<std::int64_t>(names.size());
    if (names.empty()) return "(the store is empty)";
    return fmt::format("{}{}", fmt::join(names, ", "), others > 0 ? fmt::format(" and {} more", others) : "");
  }

  // Passes on the solves of a series, up to a run.
  void read_solves(const std::string& key, std::int64_t last_run, const std::function<void(SolveRecord)>& take) {
    SQLite::Statement query(
        sqlite(), select_solves() + " WHERE series = ?1 AND (run, point) > (?2, ?3) ORDER BY run, point LIMIT ?4");
    const int run_column = query.getColumnIndex("run"), point_column = query.getColumnIndex("point");
    constexpr int at_once = 1000;  // a writer to a store without a log waits for a query to end
    std::vector<SolveRecord> read;
    std::int64_t run = std::numeric_limits<std::int64_t>::min(), point = run;  // before all stored ones
    for (int rows = at_once; rows == at_once;) {
      read.clear();
      SQLite::bind(query, key, run, point, at_once);
      for (rows = 0; query.executeStep(); ++rows) {
        try {
          run = value_in<int>(query.getColumn(run_column));
          point = value_in<int>(query.getColumn(point_column));
          if (run <= last_run) read.push_back(solve_in(query));
        } catch (const Damage& error) {
          throw Damage(
              fmt::format("{}; in the solve of run {}, point {} of series {}", error.what(), run, point, excerpt(key)));
        }
      }
      query.reset();
      for (SolveRecord& record : read) take(std::move(record));
    }
  }
};

Store::Store(const std::filesystem::path& file, Mode mode)
    : database_(guarded(file.string(), [&] { return std::make_unique<Database>(file, mode); })) {}

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

void Store::save_study(const StudyEntry& study) {
  guarded(database_->name(), [&] {
    refuse_too_many(study);
    SQLite::Transaction transaction(database_->sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
    write_study(database_->sqlite(), study);
    database_->commit(transaction);
  });
}

std::vector<StudyEntry> Store::studies() const {
  return guarded(database_->name(), [&] {
    SQLite::Statement query(database_->sqlite(), "SELECT name, definition FROM studies ORDER BY position");
    std::vector<StudyEntry> list;
    while (query.executeStep()) {
      const auto name = value_in<std::string>(query.getColumn(0));
      list.push_back({.name = name,
                      .definition = value_in<std::string>(query.getColumn(1)),
                      .series = series_in(database_->sqlite(), name)});
    }
    return list;
  });
}

StudyEntry Store::study(const std::string& name) const {
  return guarded(database_->name(), [&] {
    if (auto found = study_in(database_->sqlite(), name)) return std::move(*found);
    throw std::invalid_argument(
        fmt::format("no study '{}' in '{}'; expected one of: {}", name, database_->name(), database_->study_names()));
  });
}

std::int64_t Store::begin_session(const std::map<std::string, std::string>& environment) {
  return guarded(database_->name(), [&] {
    SQLite::Database& sqlite = database_->sqlite();
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    const std::int64_t id = write_session(sqlite, environment);
    database_->commit(transaction);
    return id;
  });
}

void Store::add_to_session(std::int64_t id, const std::map<std::string, std::string>& environment) {
  guarded(database_->name(), [&] {
    SQLite::Transaction transaction(database_->sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
    write_environment(database_->sqlite(), id, environment);
    database_->commit(transaction);
  });
}

std::vector<Session> Store::sessions() const {
  return guarded(database_->name(), [&] {
    SQLite::Statement query(
        database_->sqlite(),
        "SELECT id, key, value, began FROM sessions LEFT JOIN environment ON session = id ORDER BY id");
    std::vector<Session> list;
    while (query.executeStep()) {
      const auto id = value_in<std::int64_t>(query.getColumn(0));
      if (list.empty() || list.back().id != id)
        list.push_back({.id = id, .began = value_in<std::string>(query.getColumn(3))});
      if (!query.getColumn(1).isNull())
        list.back().environment[value_in<std::string>(query.getColumn(1))] = value_in<std::string>(query.getColumn(2));
    }
    return list;
  });
}

void Store::append(const std::vector<SolveRecord>& records) {
  guarded(database_->name(), [&] {
    SQLite::Transaction transaction(database_->sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
    write_solves(database_->sqlite(), records);
    database_->commit(transaction);
  });
}

std::vector<std::filesystem::path> Store::finish() {
  return guarded(database_->name(), [&] { return database_->finish(); });
}

void Store::at_one_moment(const std::function<void()>& action) const {
  guarded(database_->name(), [&] {
    SQLite::Transaction transaction(database_->sqlite());
    action();
    transaction.commit();
  });
}

void Store::each_of_series(const std::string& key, const std::function<void(SolveRecord)>& take) const {
  guarded(database_->name(), [&] { database_->read_solves(key, no_end, take); });
}

void Store::each_place(const std::string& key, const std::function<void(int, int)>& take) const {
  guarded(database_->name(), [&] {
    SQLite::Statement query(database_->sqlite(), "SELECT run, point FROM solves WHERE series = ?");
    query.bind(1, key);
    while (query.executeStep()) take(value_in<int>(query.getColumn(0)), value_in<int>(query.getColumn(1)));
  });
}

std::map<std::string, std::int64_t> Store::series_of_configuration(std::string_view configuration) const {
  return guarded(database_->name(), [&] {
    SQLite::Statement query(database_->sqlite(),
                            "SELECT series, count(*) FROM solves WHERE series >= ? AND series < ? GROUP BY series");
    SQLite::bind(query, fmt::format("{}{}", configuration, before_source),
                 fmt::format("{}{}", configuration, static_cast<char>(before_source + 1)));
    std::map<std::string, std::int64_t> solves;
    while (query.executeStep()) solves[value_in<std::string>(query.getColumn(0))] = query.getColumn(1).getInt64();
    return solves;
  });
}

void Store::check_solves(std::function<SolveCheck(const StudyEntry&)> make) { check_of_ = std::move(make); }

void Store::each_of_study(const StudyEntry& study, const std::function<void(SolveRecord)>& take) const {
  guarded(database_->name(), [&] {
    const Last last = last_of(study);
    const SolveCheck check = check_of_ ? check_of_(study) : nullptr;
    for (const Series& series : study.series) {
      database_->read_solves(series.key, last.run, [&](SolveRecord record) {
        if (record.point > last.point) return;
        record.study = study.name;  // also if another study's name solved it first
        record.solver = series.label;
        if (check) check(record);
        take(std::move(record));
      });
    }
  });
}

std::vector<SolveRecord> Store::solves(const std::string& study_name) const {
  std::vector<SolveRecord> list;
  each_of_study(study(study_name), [&](SolveRecord record) { list.push_back(std::move(record)); });
  return list;
}

std::int64_t Store::solves_of(const std::vector<Series>& series) const {
  return guarded(database_->name(), [&] {
    SQLite::Statement query(database_->sqlite(), "SELECT count(*) FROM solves WHERE series = ?");
    std::int64_t solves = 0;
    for (const Series& each : series) {
      query.bind(1, each.key);
      query.executeStep();
      solves += query.getColumn(0).getInt64();
      query.reset();
    }
    return solves;
  });
}

}  // namespace ikbench::results
