// Reads and writes the studies, sessions and solves of a store.
#include "results/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/Savepoint.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "numerics/json.hpp"
#include "results/store_codec.hpp"
#include "results/store_digests.hpp"
#include "results/store_file.hpp"
#include "results/store_tables.hpp"

namespace ikbench::results {
namespace {

constexpr std::int64_t no_end = std::numeric_limits<std::int64_t>::max();

// More than any study needs; we wrote no file that holds more.
constexpr std::size_t largest_json = 1'000'000;
constexpr int deepest_json = 32;
constexpr std::size_t longest_label = 1000;
constexpr std::int64_t most_runs = 1'000'000;
constexpr std::int64_t most_points = 100'000;
constexpr std::int64_t most_solves = 100'000'000;

// More solves than a study may have. A user can ask for that, too.
struct TooManySolves : Damage {
  using Damage::Damage;
};

// The depth of arrays and objects in a JSON text. Up to its first mistake a parser sees the same.
int depth_of(std::string_view json) {
  int depth = 0, deepest = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text && c == '\\')
      ++i;
    else if (c == '"')
      in_text = !in_text;
    else if (!in_text && (c == '[' || c == '{'))
      deepest = std::max(deepest, ++depth);
    else if (!in_text && (c == ']' || c == '}'))
      --depth;
  }
  return deepest;
}

// Reads an object that is not deep, since its readers may walk through it by recursion.
nlohmann::json object_in(const std::string& text, const std::string& what) {
  if (text.size() > largest_json)
    throw Damage(fmt::format("{} has {} bytes, expected at most {}", what, text.size(), largest_json));
  if (const int depth = depth_of(text); depth > deepest_json)
    throw Damage(fmt::format("{} is nested {} deep, expected at most {}", what, depth, deepest_json));
  auto json = numerics::parsed_json(text);
  if (!json.is_object()) throw Damage(fmt::format("{} is not a JSON object", what));
  return json;
}

// A whole number in a definition, from 1 to `most`.
std::int64_t defined(const nlohmann::json& definition, const char* key, std::int64_t most, const std::string& what) {
  const auto found = definition.find(key);
  const bool is_whole = found != definition.end() && found->is_number_integer();
  const bool is_huge = is_whole && found->is_number_unsigned() &&
                       found->get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<int>::max());
  if (!is_whole || is_huge || found->get<std::int64_t>() < 1 || found->get<std::int64_t>() > most)
    throw Damage(fmt::format("{} has no '{}' from 1 to {}", what, key, most));
  return found->get<std::int64_t>();
}

struct Last {
  std::int64_t run, point;
};

// Checks what holds for every study in a store; returns its last run, and its last point if it has one.
Last check_study(const StudyEntry& study) {
  const std::string name = excerpt(study.name);
  if (study.series.size() > most_series)
    throw Damage(fmt::format("study {} has more than {} series", name, most_series));
  std::set<std::string_view> keys, labels;
  for (const Series& series : study.series) {
    if (series.label.size() > longest_label)
      throw Damage(fmt::format("study {} has a label of {} bytes, expected at most {}", name, series.label.size(),
                               longest_label));
    if (!labels.insert(series.label).second)
      throw Damage(fmt::format("study {} has two series of the label {}", name, excerpt(series.label)));
    if (!keys.insert(series.key).second)
      throw Damage(fmt::format("study {} has two series of the key {}", name, excerpt(series.key)));
    object_in(series.options, fmt::format("the text of the options of {} in study {}", excerpt(series.label), name));
  }
  const std::string what = fmt::format("the definition of study {}", name);
  const auto definition = object_in(study.definition, what);
  const std::int64_t runs = defined(definition, "runs", most_runs, what);
  const bool has_points = definition.contains("points");
  const std::int64_t points = has_points ? defined(definition, "points", most_points, what) : 1;
  const std::int64_t solves = runs * points * static_cast<std::int64_t>(study.series.size());
  if (solves > most_solves)
    throw TooManySolves(fmt::format("study {} asks for {} solves ({} runs, {} points, {} series); expected at most {}",
                                    name, solves, runs, points, study.series.size(), most_solves));
  return {.run = runs, .point = has_points ? points : no_end};
}

}  // namespace

struct Store::Database : StoreFile {
  using StoreFile::StoreFile;

  std::vector<Series> series_of(const std::string& study) {
    refuse_blobs("series", "study");
    return series_in(sqlite(), study);
  }

  std::optional<StudyEntry> find_study(const std::string& name) {
    refuse_blobs("series", "study");
    std::optional<StudyEntry> study = study_in(sqlite(), name);
    if (study) check_study(*study);
    return study;
  }

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

  // Passes on the solves of a series, up to a run, and adds up their digests the first time.
  void read_solves(const std::string& key, std::int64_t last_run, const std::function<void(SolveRecord)>& take) {
    refuse_blobs("solves", "series");
    SQLite::Statement query(
        sqlite(), select_solves() + " WHERE series = ?1 AND (run, point) > (?2, ?3) ORDER BY run, point LIMIT ?4");
    const int run_column = query.getColumnIndex("run"), point_column = query.getColumnIndex("point");
    if (summed_.of_series.empty())
      summed_.next_row = sqlite().execAndGet("SELECT coalesce(max(rowid), 0) + 1 FROM solves").getInt64();
    std::optional<SolveAdder> adder;
    if (!summed_.of_series.contains(key)) adder.emplace(query);
    SolveSums sums;
    constexpr int at_once = 1000;  // a writer to a store without a log waits for a query to end
    std::vector<SolveRecord> read;
    std::int64_t run = std::numeric_limits<std::int64_t>::min(), point = run;  // before all stored ones
    for (int rows = at_once; rows == at_once;) {
      read.clear();
      SQLite::bind(query, key, run, point, at_once);
      for (rows = 0; query.executeStep(); ++rows) {
        at_solve(query, [&] {
          run = value_in<int>(query.getColumn(run_column));
          point = value_in<std::int64_t>(query.getColumn(point_column));
          if (run <= last_run) read.push_back(solve_in(query));
          if (adder && adder->rowid() < summed_.next_row) adder->add_to(sums);
        });
      }
      query.reset();
      for (SolveRecord& record : read) take(std::move(record));
    }
    if (adder) summed_.of_series.emplace(key, std::move(sums));
  }

  const Summed& summed() const { return summed_; }

 private:
  Summed summed_;
};

Store::Store(const std::filesystem::path& file, Mode mode)
    : database_(guarded(file.string(), [&] { return std::make_unique<Database>(file, mode); })) {}

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

const std::string& Store::name() const { return database_->name(); }

void Store::save_study(const StudyEntry& study) {
  try {
    check_study(study);
  } catch (const TooManySolves& error) {
    throw std::invalid_argument(error.what());
  } catch (const Damage& error) {
    throw std::logic_error(error.what());
  }

  guarded(database_->name(), [&] {
    SQLite::Transaction transaction(database_->sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
    write_study(database_->sqlite(), study);
    database_->commit(transaction);
  });
}

std::vector<StudyEntry> Store::studies() const {
  return guarded(database_->name(), [&] {
    SQLite::Statement query(database_->sqlite(), "SELECT name, definition FROM studies ORDER BY position");
    std::vector<StudyEntry> list;
    std::set<std::string> names;
    while (query.executeStep()) {
      const auto name = value_in<std::string>(query.getColumn(0));
      if (!names.insert(name).second) throw Damage(fmt::format("two studies have the name {}", excerpt(name)));
      list.push_back({.name = name,
                      .definition = value_in<std::string>(query.getColumn(1)),
                      .series = database_->series_of(name)});
      check_study(list.back());
    }
    return list;
  });
}

StudyEntry Store::study(const std::string& name) const {
  return guarded(database_->name(), [&] {
    if (auto found = database_->find_study(name)) return std::move(*found);
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
    add_to_digest(database_->sqlite(), id, {.sum = digest_of(environment)});
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
    SQLite::Statement astray(database_->sqlite(), "SELECT session FROM environment WHERE typeof(session) <> 'integer'");
    if (astray.executeStep()) value_in<std::int64_t>(astray.getColumn(0));  // the join would skip it
    return list;
  });
}

void Store::append(const std::vector<SolveRecord>& records) {
  guarded(database_->name(), [&] {
    SQLite::Transaction transaction(database_->sqlite(), SQLite::TransactionBehavior::IMMEDIATE);
    write_solves(database_->sqlite(), records);
    database_->commit(transaction, static_cast<std::int64_t>(records.size()));
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

std::vector<std::int64_t> Store::sessions_of(const std::vector<Series>& series) const {
  return guarded(database_->name(), [&] {
    SQLite::Statement query(database_->sqlite(), "SELECT DISTINCT session FROM solves WHERE series = ?");
    std::set<std::int64_t> sessions;
    for (const Series& each : series) {
      query.bind(1, each.key);
      while (query.executeStep()) sessions.insert(value_in<std::int64_t>(query.getColumn(0)));
      query.reset();
    }
    return std::vector<std::int64_t>(sessions.begin(), sessions.end());
  });
}

std::map<std::string, std::int64_t> Store::series_of_configuration(std::string_view configuration) const {
  return guarded(database_->name(), [&] {
    database_->refuse_blobs("solves", "series");
    SQLite::Statement query(database_->sqlite(),
                            "SELECT series, count(*) FROM solves WHERE series >= ? AND series < ? GROUP BY series");
    SQLite::bind(query, fmt::format("{}{}", configuration, before_source),
                 fmt::format("{}{}", configuration, static_cast<char>(before_source + 1)));
    std::map<std::string, std::int64_t> solves;
    while (query.executeStep()) solves[value_in<std::string>(query.getColumn(0))] = query.getColumn(1).getInt64();
    return solves;
  });
}

void Store::each_of_study(const StudyEntry& study, const std::function<void(SolveRecord)>& take) const {
  guarded(database_->name(), [&] {
    const Last last = check_study(study);
    for (const Series& series : study.series) {
      database_->read_solves(series.key, last.run, [&](SolveRecord record) {
        if (record.point > last.point) return;
        if (record.solver != series.label)
          throw Damage(fmt::format("solver {} in run {}, point {} of the series of {}", excerpt(record.solver),
                                   record.run, record.point, excerpt(series.label)));
        record.study = study.name;  // also if another study's name solved it first
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

Changes Store::changes(const std::vector<std::string>& studies) const {
  return guarded(database_->name(), [&] {
    SQLite::Savepoint one_moment(database_->sqlite(), "one_moment");
    Written written = written_in(database_->sqlite());
    for (const std::string& name : studies) written.studies.push_back(study(name));
    written.sessions = sessions();
    one_moment.release();
    return changes_since(database_->sqlite(), written, database_->summed());
  });
}

int Store::runs_begun(const StudyEntry& study) const {
  return guarded(database_->name(), [&] {
    SQLite::Statement query(database_->sqlite(), "SELECT DISTINCT run FROM solves WHERE series = ? AND run <= ?");
    std::set<int> runs;
    for (const Series& series : study.series) {
      query.bind(1, series.key);
      query.bind(2, check_study(study).run);
      while (query.executeStep()) runs.insert(query.getColumn(0).getInt());
      query.reset();
    }
    return static_cast<int>(runs.size());
  });
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
