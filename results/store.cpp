// The store as an SQLite file, through SQLiteCpp. While it is written it has a write-ahead log beside it
// (https://www.sqlite.org/wal.html): a process that is killed loses nothing that was committed, and one transaction
// per solve costs no wait for the disk. The last writer to close folds the log in: a finished store is one plain file.
#include "results/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

#include "results/number.hpp"

namespace ikbench {
namespace {

constexpr std::int64_t application_id = 0x494B424E;  // "IKBN" in the header of the file
constexpr std::int64_t schema_version = 1;           // docs/data-dictionary.md: when it is raised
constexpr int busy_timeout_ms = 10'000;
constexpr std::int64_t all_runs = std::numeric_limits<std::int64_t>::max();

// Something in the file that no store of ours has.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] void refuse_damaged(const std::string& file, const std::string& what) {
  throw std::invalid_argument(
      fmt::format("'{}' is damaged ({}); restore it from a copy or run its studies into a new store", file, what));
}

// SQLite's word for what went wrong, as a sentence about the file.
[[noreturn]] void refuse(const std::string& file, const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      throw std::invalid_argument(
          fmt::format("'{}' is not an ikbench store: it is no SQLite file; expected one that ikbench wrote", file));
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // our SQL is right, so the tables are not ours
      refuse_damaged(file, error.what());
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_READONLY:
      throw std::invalid_argument(fmt::format(
          "'{}' cannot be opened ({}); it, its folder or a '-wal' file that a run left beside it cannot be read or "
          "written: give permission, or copy the store with its '-wal' file to a folder where you can write",
          file, error.what()));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw std::runtime_error(fmt::format(
          "'{}' was kept locked by another process for {} s; wait until that has ended", file, busy_timeout_ms / 1000));
    case SQLITE_CONSTRAINT:
      if (error.getExtendedErrorCode() != SQLITE_CONSTRAINT_PRIMARYKEY) {
        throw std::logic_error(fmt::format("'{}' already has it: {}", file, error.what()));
      }
      throw std::runtime_error(fmt::format(
          "'{}' has that solve already ({}): another ikbench runs the same study into it; wait for it, then run again",
          file, error.what()));
    default:
      throw std::runtime_error(fmt::format("'{}' cannot be used: {}", file, error.what()));
  }
}

template <class Action>
auto guarded(const std::string& file, Action&& action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    refuse(file, error);
  } catch (const Damage& error) {
    refuse_damaged(file, error.what());
  }
}

// A list of numbers as a JSON array. JSON has neither NaN nor infinity: null, and 1e999, which every reader
// rounds to infinity.
constexpr std::string_view json_nan = "null";
constexpr std::string_view json_infinity = "1e999";
constexpr std::string_view json_minus_infinity = "-1e999";

std::string json_array(const std::vector<double>& numbers) {
  std::string text = "[";
  for (const double number : numbers) {
    if (text.size() > 1) text += ',';
    if (std::isfinite(number))
      text += text_of(number);
    else
      text += std::isnan(number) ? json_nan : number > 0 ? json_infinity : json_minus_infinity;
  }
  return text + "]";
}

double json_number(std::string_view text) {
  if (text == json_nan) return std::numeric_limits<double>::quiet_NaN();
  if (text == json_infinity) return std::numeric_limits<double>::infinity();
  if (text == json_minus_infinity) return -std::numeric_limits<double>::infinity();
  if (const auto number = number_from(text)) return *number;
  throw Damage(fmt::format("'{}' in a list of numbers", text));
}

std::vector<double> numbers_from(std::string_view array) {
  if (array.size() < 2 || array.front() != '[' || array.back() != ']')
    throw Damage(fmt::format("'{}' is not a list of numbers", array.substr(0, 40)));
  std::vector<double> numbers;
  std::string_view rest = array.substr(1, array.size() - 2);
  if (rest.empty()) return numbers;
  numbers.reserve(static_cast<std::size_t>(std::count(rest.begin(), rest.end(), ',')) + 1);
  for (;;) {
    const std::size_t comma = rest.find(',');
    numbers.push_back(json_number(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return numbers;
    rest.remove_prefix(comma + 1);
  }
}

// How a member of the record is declared, written and read. SQLite has no NaN: NULL stands for it.
template <class Value>
constexpr std::string_view sql_type() {
  if constexpr (std::is_integral_v<Value>) return "INTEGER NOT NULL";
  if constexpr (std::is_floating_point_v<Value>) return "REAL";
  return "TEXT NOT NULL";
}

template <class Value>
void bind(SQLite::Statement& statement, int index, const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    statement.bind(index, std::string(name_of(value)));
  else if constexpr (std::is_same_v<Value, std::vector<double>>)
    statement.bind(index, json_array(value));
  else
    statement.bind(index, value);
}

template <class Value>
void read(const SQLite::Column& column, Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    const auto& names = names_of(value);
    const auto found = std::find(names.begin(), names.end(), column.getString());
    if (found == names.end()) throw Damage(fmt::format("{} '{}'", column.getName(), column.getString()));
    value = static_cast<Value>(found - names.begin());
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    value = numbers_from(column.getString());
  } else if constexpr (std::is_floating_point_v<Value>) {
    value = column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
  } else if constexpr (std::is_integral_v<Value>) {
    if (!std::in_range<Value>(column.getInt64()))
      throw Damage(fmt::format("{} {}", column.getName(), column.getInt64()));
    value = static_cast<Value>(column.getInt64());
  } else {
    value = column.getString();
  }
}

// The columns of `solves`, each through `format` and separated by commas.
template <class Format>
std::string solve_columns(Format&& format) {
  std::string text;
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*, std::string_view) {
    text += text.empty() ? "" : ", ";
    text += format(name, sql_type<Value>());
  });
  return text;
}

std::string create_tables() {
  return fmt::format(
      R"sql(
PRAGMA application_id = {};
PRAGMA user_version = {};
CREATE TABLE meta (key TEXT NOT NULL PRIMARY KEY, value TEXT NOT NULL);
INSERT INTO meta VALUES ('schema', '{}'), ('written by', 'ikbench; the columns are described in docs/data-dictionary.md');
CREATE TABLE studies (position INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, definition TEXT NOT NULL,
                      saved TEXT NOT NULL);
CREATE TABLE series (study TEXT NOT NULL, position INTEGER NOT NULL, key TEXT NOT NULL, label TEXT NOT NULL,
                     algorithm TEXT NOT NULL, options TEXT NOT NULL,
                     PRIMARY KEY (study, position), UNIQUE (study, key), UNIQUE (study, label));
CREATE TABLE sessions (id INTEGER PRIMARY KEY, began TEXT NOT NULL);
CREATE TABLE environment (session INTEGER NOT NULL, key TEXT NOT NULL, value TEXT NOT NULL, PRIMARY KEY (session, key));
CREATE TABLE solves ({}, PRIMARY KEY (series, run, point));
)sql",
      application_id, schema_version, schema_version,
      solve_columns([](auto name, auto type) { return fmt::format("{} {}", name, type); }));
}

std::string insert_solve() {
  return fmt::format("INSERT INTO solves ({}) VALUES ({})", solve_columns([](auto name, auto) { return name; }),
                     solve_columns([](auto, auto) { return "?"; }));
}

std::string select_solves() {
  return fmt::format("SELECT {} FROM solves WHERE series = ? AND run <= ? ORDER BY run, point",
                     solve_columns([](auto name, auto) { return name; }));
}

constexpr const char* now = "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')";

// Nothing where the definition is not a JSON object with an integer `runs`.
std::optional<std::int64_t> runs_of(const StudyEntry& study) {
  const auto definition = nlohmann::json::parse(study.definition, nullptr, false);
  if (!definition.is_object() || !definition.contains("runs") || !definition["runs"].is_number_integer())
    return std::nullopt;
  return definition["runs"].get<std::int64_t>();
}

// The path for SQLite, absolute so that it never means something special (":memory:").
std::string checked_path(const std::filesystem::path& file, Store::Mode mode) {
  std::error_code error;
  const auto path = std::filesystem::absolute(file, error);
  const auto status = std::filesystem::status(path, error);
  if (file.empty() || std::filesystem::is_directory(status))
    throw std::invalid_argument(fmt::format("'{}' is a folder, expected the file of a store", file.string()));
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw std::invalid_argument(fmt::format("'{}' is not a regular file, expected the file of a store", file.string()));
  if (mode == Store::Mode::read && status.type() == std::filesystem::file_type::not_found)
    throw std::invalid_argument(
        fmt::format("'{}' does not exist, expected a store; `ikbench run` writes one", file.string()));
  if (mode == Store::Mode::write) {
    std::filesystem::create_directories(path.parent_path(), error);
    if (error)
      throw std::invalid_argument(fmt::format(
          "'{}' cannot be written: its folder cannot be made ({}); give another path", file.string(), error.message()));
  }
  return path.string();
}

}  // namespace

struct Store::Database {
  std::string file;  // as the user named it
  Mode mode;
  SQLite::Database sqlite;

  Database(const std::filesystem::path& path, Mode open_mode)
      : file(path.string()),
        mode(open_mode),
        sqlite(checked_path(path, mode),
               mode == Mode::write ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE : SQLite::OPEN_READONLY,
               busy_timeout_ms) {
    if (mode == Mode::read) {
      check_header();
      return;
    }
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    if (number("SELECT count(*) FROM sqlite_master") == 0 && number("PRAGMA application_id") == 0)
      sqlite.exec(create_tables());
    check_header();
    transaction.commit();
    sqlite.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  }

  ~Database() {
    if (mode == Mode::read) return;
    try {
      sqlite.setBusyTimeout(0);
      sqlite.exec("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE");
    } catch (const SQLite::Exception&) {
      // Another process has the store open: what is committed is safe, and the last to close folds the log in.
    }
  }

  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  std::int64_t number(const char* query) { return sqlite.execAndGet(query).getInt64(); }

  void check_header() {
    if (number("PRAGMA application_id") != application_id)
      throw std::invalid_argument(
          fmt::format("'{}' is not an ikbench store: another program wrote it; expected one that ikbench wrote", file));
    if (const auto version = number("PRAGMA user_version"); version > schema_version)
      throw std::invalid_argument(
          fmt::format("'{}' has schema {}, newer than the {} that this ikbench knows; use the ikbench that wrote it",
                      file, version, schema_version));
    // SQLite takes what is missing of the last page for zeros.
    if (std::filesystem::file_size(file) % static_cast<std::uintmax_t>(number("PRAGMA page_size")) != 0)
      throw Damage("it was cut short");
  }

  std::vector<Series> series_of(const std::string& study) {
    SQLite::Statement query(sqlite,
                            "SELECT key, label, algorithm, options FROM series WHERE study = ? ORDER BY position");
    query.bind(1, study);
    std::vector<Series> list;
    while (query.executeStep())
      list.push_back({.key = query.getColumn(0).getString(),
                      .label = query.getColumn(1).getString(),
                      .algorithm = query.getColumn(2).getString(),
                      .options = query.getColumn(3).getString()});
    return list;
  }

  // Appends the solves of a series, up to a run, to the list.
  void read_solves(const std::string& key, std::int64_t last_run, std::vector<SolveRecord>& list) {
    SQLite::Statement query(sqlite, select_solves());
    query.bind(1, key);
    query.bind(2, last_run);
    while (query.executeStep()) {
      SolveRecord& record = list.emplace_back();
      int index = 0;
      for_each_column(
          [&](std::string_view, auto member, std::string_view) { read(query.getColumn(index++), record.*member); });
    }
  }
};

Store::Store(const std::filesystem::path& file, Mode mode)
    : database_(guarded(file.string(), [&] { return std::make_unique<Database>(file, mode); })) {}

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

void Store::save_study(const StudyEntry& study) {
  if (!runs_of(study))
    throw std::logic_error(
        fmt::format("definition of study '{}' is not a JSON object with an integer 'runs'", study.name));
  for (const Series& series : study.series)
    if (!nlohmann::json::accept(series.options))
      throw std::logic_error(fmt::format("options of '{}' in study '{}' are not JSON", series.label, study.name));

  guarded(database_->file, [&] {
    SQLite::Database& sqlite = database_->sqlite;
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement save(sqlite, fmt::format("INSERT INTO studies (name, definition, saved) VALUES (?1, ?2, {0}) "
                                               "ON CONFLICT (name) DO UPDATE SET definition = ?2, saved = {0}",
                                               now));
    save.bind(1, study.name);
    save.bind(2, study.definition);
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
    transaction.commit();
  });
}

std::vector<StudyEntry> Store::studies() const {
  return guarded(database_->file, [&] {
    SQLite::Statement query(database_->sqlite, "SELECT name, definition FROM studies ORDER BY position");
    std::vector<StudyEntry> list;
    while (query.executeStep()) {
      const std::string name = query.getColumn(0).getString();
      list.push_back(
          {.name = name, .definition = query.getColumn(1).getString(), .series = database_->series_of(name)});
    }
    return list;
  });
}

StudyEntry Store::study(const std::string& name) const {
  std::vector<std::string> names;
  for (StudyEntry& study : studies()) {
    if (study.name == name) return std::move(study);
    names.push_back(study.name);
  }
  throw std::invalid_argument(
      fmt::format("no study '{}' in '{}', expected one of: {}", name, database_->file,
                  names.empty() ? "(the store is empty)" : fmt::format("{}", fmt::join(names, ", "))));
}

std::int64_t Store::begin_session(const std::map<std::string, std::string>& environment) {
  return guarded(database_->file, [&] {
    SQLite::Database& sqlite = database_->sqlite;
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    sqlite.exec(fmt::format("INSERT INTO sessions (began) VALUES ({})", now));
    const std::int64_t id = sqlite.getLastInsertRowid();
    SQLite::Statement add(sqlite, "INSERT INTO environment (session, key, value) VALUES (?, ?, ?)");
    for (const auto& [key, value] : environment) {
      SQLite::bind(add, id, key, value);
      add.exec();
      add.reset();
    }
    transaction.commit();
    return id;
  });
}

std::vector<Session> Store::sessions() const {
  return guarded(database_->file, [&] {
    SQLite::Statement query(database_->sqlite,
                            "SELECT id, key, value FROM sessions LEFT JOIN environment ON session = id ORDER BY id");
    std::vector<Session> list;
    while (query.executeStep()) {
      const std::int64_t id = query.getColumn(0).getInt64();
      if (list.empty() || list.back().id != id) list.push_back({.id = id, .environment = {}});
      if (!query.getColumn(1).isNull())
        list.back().environment[query.getColumn(1).getString()] = query.getColumn(2).getString();
    }
    return list;
  });
}

void Store::append(const std::vector<SolveRecord>& records) {
  guarded(database_->file, [&] {
    SQLite::Transaction transaction(database_->sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement insert(database_->sqlite, insert_solve());
    for (const SolveRecord& record : records) {
      int index = 0;
      for_each_column([&](std::string_view, auto member, std::string_view) { bind(insert, ++index, record.*member); });
      insert.exec();
      insert.reset();
    }
    transaction.commit();
  });
}

std::vector<SolveRecord> Store::series(const std::string& key) const {
  return guarded(database_->file, [&] {
    std::vector<SolveRecord> list;
    database_->read_solves(key, all_runs, list);
    return list;
  });
}

std::vector<SolveRecord> Store::solves(const std::string& study_name) const {
  return guarded(database_->file, [&] {
    const StudyEntry entry = study(study_name);
    const auto runs = runs_of(entry);
    if (!runs) throw Damage(fmt::format("the definition of study '{}'", study_name));
    std::vector<SolveRecord> list;
    for (const Series& series : entry.series) database_->read_solves(series.key, *runs, list);
    for (SolveRecord& record : list) record.study = study_name;  // also where another name first solved it
    return list;
  });
}

}  // namespace ikbench
