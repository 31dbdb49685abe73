// The store as an SQLite file, through SQLiteCpp. While it is written it has a write-ahead log beside it
// (https://www.sqlite.org/wal.html): a process that is killed loses nothing that was committed, and one transaction
// per solve costs no wait for the disk. The last writer to finish folds the log in: a finished store is one plain file.
#include "results/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

#include "numerics/number.hpp"

namespace ikbench::results {

using namespace numerics;

namespace {

constexpr std::int64_t application_id = 0x494B424E;  // "IKBN" in the header of the file
constexpr std::int64_t schema_version = 1;           // docs/data-dictionary.md: when it is raised
constexpr int busy_timeout_ms = 10'000;
constexpr std::chrono::seconds folding_patience{5};
constexpr std::int64_t all_runs = std::numeric_limits<std::int64_t>::max();

// More than any study needs; a file that holds more was not written by us.
constexpr int largest_value = 256'000'000;  // bytes of a text in the file
constexpr std::size_t largest_json = 1'000'000;
constexpr int deepest_json = 32;
constexpr std::size_t longest_label = 1000;
constexpr std::size_t most_series = 1000;
constexpr std::int64_t most_runs = 1'000'000;
constexpr std::int64_t most_points = 100'000;
constexpr std::int64_t most_solves = 100'000'000;

// Something in the file that no store of ours has.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// More solves than a study may have, which a user can ask for too.
struct TooManySolves : Damage {
  using Damage::Damage;
};

// Text of the file within a sentence.
std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 40;
  return text.size() <= longest ? fmt::format("'{}'", text) : fmt::format("'{}...'", text.substr(0, longest));
}

[[noreturn]] void refuse_damaged(const std::string& file, const std::string& what) {
  throw std::invalid_argument(
      fmt::format("'{}' is damaged ({}); restore it from a copy or run its studies into a new store", file, what));
}

[[noreturn]] void refuse_taken_away(const std::string& file) {
  throw std::runtime_error(fmt::format(
      "'{}' was removed, moved or replaced while ikbench wrote to it, so the new solves are not in it; if it "
      "was moved, move it back; then run again",
      file));
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
    case SQLITE_TOOBIG:
      throw std::invalid_argument(
          fmt::format("'{}' cannot hold a value of more than {} MB; expected a shorter text, list or trace", file,
                      largest_value / 1'000'000));
    case SQLITE_READONLY:
      if (error.getExtendedErrorCode() == SQLITE_READONLY_DBMOVED) refuse_taken_away(file);
      if (error.getExtendedErrorCode() == SQLITE_READONLY_ROLLBACK)
        throw std::invalid_argument(
            fmt::format("'{}' was left half-written by an ikbench that was killed: keep '{}-journal' beside it and run the "
                        "study again, which undoes the unfinished write and goes on",
                        file, file));
      [[fallthrough]];
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
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
      throw std::invalid_argument(fmt::format(
          "another ikbench is running the same study into '{}'; wait until it has ended, then run again", file));
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
  throw Damage(fmt::format("{} in a list of numbers", shortened(text)));
}

std::vector<double> numbers_from(std::string_view array) {
  if (array.size() < 2 || array.front() != '[' || array.back() != ']')
    throw Damage(fmt::format("{} is not a list of numbers", shortened(array)));
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

std::string shown(const SQLite::Column& column) {
  if (column.isNull()) return "NULL";
  if (column.isBlob()) return "(BLOB)";
  return column.isText() ? shortened(column.getString()) : column.getString();
}

// SQLite keeps a value of any type in a column of any type, and would give a wrong one as 0 or as text.
void expect(bool is_right, const SQLite::Column& column, std::string_view type) {
  if (!is_right) throw Damage(fmt::format("{} {}, expected {}", column.getName(), shown(column), type));
}

template <class Value>
void read(const SQLite::Column& column, Value& value) {
  if constexpr (std::is_floating_point_v<Value>) {
    expect(column.isFloat() || column.isInteger() || column.isNull(), column, "a number");
    value = column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
  } else if constexpr (std::is_integral_v<Value>) {
    expect(column.isInteger(), column, "a whole number");
    if (!std::in_range<Value>(column.getInt64()))
      throw Damage(fmt::format("{} {}", column.getName(), column.getInt64()));
    value = static_cast<Value>(column.getInt64());
  } else {
    expect(column.isText(), column, "text");
    if constexpr (std::is_enum_v<Value>) {
      const auto& names = names_of(value);
      const auto found = std::find(names.begin(), names.end(), column.getString());
      if (found == names.end()) throw Damage(fmt::format("{} {}", column.getName(), shown(column)));
      value = static_cast<Value>(found - names.begin());
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
      try {
        value = numbers_from(column.getString());
      } catch (const Damage& error) {
        throw Damage(fmt::format("{}: {}", column.getName(), error.what()));
      }
    } else {
      value = column.getString();
    }
  }
}

template <class Value>
Value value_in(const SQLite::Column& column) {
  Value value{};
  read(column, value);
  return value;
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

struct TableMaker {
  std::string_view name;
  std::string sql;
};

std::vector<TableMaker> tables() {
  return {
      {"meta", "CREATE TABLE meta (key TEXT NOT NULL PRIMARY KEY, value TEXT NOT NULL)"},
      {"studies",
       "CREATE TABLE studies (position INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, definition TEXT NOT NULL, "
       "saved TEXT NOT NULL)"},
      {"series",
       "CREATE TABLE series (study TEXT NOT NULL, position INTEGER NOT NULL, key TEXT NOT NULL, label TEXT NOT NULL, "
       "algorithm TEXT NOT NULL, options TEXT NOT NULL, PRIMARY KEY (study, position), UNIQUE (study, key), "
       "UNIQUE (study, label))"},
      {"sessions", "CREATE TABLE sessions (id INTEGER PRIMARY KEY, began TEXT NOT NULL)"},
      {"environment",
       "CREATE TABLE environment (session INTEGER NOT NULL, key TEXT NOT NULL, value TEXT NOT NULL, "
       "PRIMARY KEY (session, key))"},
      {"solves", fmt::format("CREATE TABLE solves ({}, PRIMARY KEY (series, run, point))",
                             solve_columns([](auto name, auto type) { return fmt::format("{} {}", name, type); }))}};
}

std::string create_tables() {
  std::string sql =
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};\n", application_id, schema_version);
  for (const TableMaker& table : tables()) sql += table.sql + ";\n";
  return sql + fmt::format(
                   "INSERT INTO meta VALUES ('schema', '{}'), ('written by', 'ikbench; the columns are "
                   "described in docs/data-dictionary.md');\n",
                   schema_version);
}

// SQL with every run of white space as one space.
std::string on_one_line(std::string_view sql) {
  std::string text;
  for (const char c : sql) {
    if (std::isspace(static_cast<unsigned char>(c)) == 0)
      text += c;
    else if (!text.empty() && text.back() != ' ')
      text += ' ';
  }
  return text;
}

std::string insert_solve() {
  return fmt::format("INSERT INTO solves ({}) VALUES ({})", solve_columns([](auto name, auto) { return name; }),
                     solve_columns([](auto, auto) { return "?"; }));
}

std::string select_solves() {
  return fmt::format("SELECT {} FROM solves WHERE series = ? ORDER BY run, point",
                     solve_columns([](auto name, auto) { return name; }));
}

constexpr const char* now = "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')";

// How deep the arrays and objects of a JSON text are nested. Up to its first mistake this is what a parser sees.
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

// Whoever reads the object may walk through it by recursion, so it must not be deep.
nlohmann::json object_in(const std::string& text, const std::string& what) {
  if (text.size() > largest_json)
    throw Damage(fmt::format("{} has {} bytes, expected at most {}", what, text.size(), largest_json));
  if (const int depth = depth_of(text); depth > deepest_json)
    throw Damage(fmt::format("{} is nested {} deep, expected at most {}", what, depth, deepest_json));
  auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) throw Damage(fmt::format("{} is not a JSON object", what));
  return json;
}

// A whole number of a definition, from 1 to `most`.
std::int64_t defined(const nlohmann::json& definition, const char* key, std::int64_t most, const std::string& what) {
  const auto found = definition.find(key);
  const bool is_whole = found != definition.end() && found->is_number_integer();
  const bool is_huge = is_whole && found->is_number_unsigned() &&
                       found->get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<int>::max());
  if (!is_whole || is_huge || found->get<std::int64_t>() < 1 || found->get<std::int64_t>() > most)
    throw Damage(fmt::format("{} has no '{}' from 1 to {}", what, key, most));
  return found->get<std::int64_t>();
}

// What every study in a store is; returns its runs.
std::int64_t check_study(const StudyEntry& study) {
  const std::string name = shortened(study.name);
  if (study.series.size() > most_series)
    throw Damage(fmt::format("study {} has more than {} series", name, most_series));
  std::set<std::string_view> keys, labels;
  for (const Series& series : study.series) {
    if (series.label.size() > longest_label)
      throw Damage(fmt::format("study {} has a label of {} bytes, expected at most {}", name, series.label.size(),
                               longest_label));
    if (!labels.insert(series.label).second)
      throw Damage(fmt::format("study {} has two series of the label {}", name, shortened(series.label)));
    if (!keys.insert(series.key).second)
      throw Damage(fmt::format("study {} has two series of the key {}", name, shortened(series.key)));
    object_in(series.options, fmt::format("the text of the options of {} in study {}", shortened(series.label), name));
  }
  const std::string what = fmt::format("the definition of study {}", name);
  const auto definition = object_in(study.definition, what);
  const std::int64_t runs = defined(definition, "runs", most_runs, what);
  const std::int64_t points = definition.contains("points") ? defined(definition, "points", most_points, what) : 1;
  const std::int64_t solves = runs * points * static_cast<std::int64_t>(study.series.size());
  if (solves > most_solves)
    throw TooManySolves(fmt::format("study {} asks for {} solves ({} runs, {} points, {} series), expected at most {}",
                                    name, solves, runs, points, study.series.size(), most_solves));
  return runs;
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

// Which file a path leads to: its device and number there.
using FileIdentity = std::pair<dev_t, ino_t>;

std::optional<FileIdentity> identity_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileIdentity{status.st_dev, status.st_ino};
}

}  // namespace

struct Store::Database {
  std::string file;  // as the user named it
  Mode mode;
  SQLite::Database sqlite;
  std::optional<FileIdentity> identity;  // of the file that was opened

  Database(const std::filesystem::path& path, Mode open_mode)
      : file(path.string()),
        mode(open_mode),
        sqlite(checked_path(path, mode),
               mode == Mode::write ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE : SQLite::OPEN_READONLY,
               busy_timeout_ms),
        identity(identity_of(sqlite.getFilename())) {
    distrust();
    if (mode == Mode::read) {
      check_header();
      check_schema();
      return;
    }
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    if (number("SELECT count(*) FROM sqlite_master") == 0 && number("PRAGMA application_id") == 0)
      sqlite.exec(create_tables());
    check_header();
    check_schema();
    transaction.commit();
    sqlite.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  }

  ~Database() {
    if (mode == Mode::write) fold();
  }

  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  // SQLite goes on writing a file that was unlinked or moved away.
  bool is_in_place() const { return identity && identity_of(sqlite.getFilename()) == identity; }

  void check_place() const {
    if (!is_in_place()) refuse_taken_away(file);
  }

  void commit(SQLite::Transaction& transaction) {
    transaction.commit();
    check_place();
  }

  // Whether the log could be folded in: not while another process reads or writes. What is committed is safe all the
  // same, and the next to write folds it in.
  bool fold() {
    try {
      sqlite.setBusyTimeout(0);
      sqlite.exec("PRAGMA wal_checkpoint(TRUNCATE)");
      if (is_in_place()) sqlite.exec("PRAGMA journal_mode = DELETE");  // else it would remove the log of another file
      return true;
    } catch (const SQLite::Exception&) {
      return false;
    }
  }

  void fold_with_patience() {
    const auto deadline = std::chrono::steady_clock::now() + folding_patience;
    while (!fold() && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    sqlite.setBusyTimeout(busy_timeout_ms);
  }

  std::int64_t number(const char* query) { return sqlite.execAndGet(query).getInt64(); }

  // The file may be anybody's: none of its SQL is run (https://www.sqlite.org/security.html).
  void distrust() {
    sqlite3* const handle = sqlite.getHandle();
    for (const auto& [option, value] :
         {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1}, std::pair{SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
          std::pair{SQLITE_DBCONFIG_ENABLE_TRIGGER, 0}, std::pair{SQLITE_DBCONFIG_ENABLE_VIEW, 0}})
      sqlite3_db_config(handle, option, value, static_cast<int*>(nullptr));
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, largest_value);
    sqlite.exec("PRAGMA cell_size_check = ON");
  }

  void check_header() {
    if (number("PRAGMA application_id") != application_id)
      throw std::invalid_argument(
          fmt::format("'{}' is not an ikbench store: another program wrote it; expected one that ikbench wrote", file));
    if (const auto version = number("PRAGMA user_version"); version > schema_version)
      throw std::invalid_argument(
          fmt::format("'{}' has schema {}, newer than the {} that this ikbench knows; use the ikbench that wrote it",
                      file, version, schema_version));
    else if (version < schema_version)
      throw Damage(fmt::format("its user_version is {}, expected {}", version, schema_version));
    // SQLite takes what is missing of the last page for zeros.
    if (std::filesystem::file_size(file) % static_cast<std::uintmax_t>(number("PRAGMA page_size")) != 0)
      throw Damage("it was cut short");
  }

  // Our tables, as we make them, and nothing else.
  void check_schema() {
    if (const std::string encoding = sqlite.execAndGet("PRAGMA encoding").getString(); encoding != "UTF-8")
      throw Damage(fmt::format("its encoding is {}, expected UTF-8", encoding));
    std::vector<TableMaker> missing = tables();
    const auto is_ours = [ours = tables()](const std::string& name) {
      return std::ranges::find(ours, name, &TableMaker::name) != ours.end();
    };
    SQLite::Statement query(sqlite, "SELECT type, name, tbl_name, sql FROM sqlite_master");
    while (query.executeStep()) {
      const std::string type = query.getColumn(0).getString();
      const std::string name = query.getColumn(1).getString();
      const bool is_automatic = query.getColumn(3).isNull() && name.starts_with("sqlite_autoindex_");
      if (type == "index" && is_automatic && is_ours(query.getColumn(2).getString())) continue;
      const auto found = std::ranges::find(missing, name, &TableMaker::name);
      if (type != "table" || found == missing.end())
        throw Damage(fmt::format("it holds {} {}, which no store of ikbench has", type.substr(0, 40), shortened(name)));
      if (on_one_line(query.getColumn(3).getString()) != found->sql)
        throw Damage(fmt::format("its table {} has other columns or constraints than ikbench gives it", name));
      missing.erase(found);
    }
    if (!missing.empty()) throw Damage(fmt::format("it has no table '{}'", missing.front().name));
  }

  // Blobs equal no text, so that a search would pass over them; they come after every text.
  void refuse_blobs(const char* table, const char* column) {
    if (SQLite::Statement(sqlite, fmt::format("SELECT 1 FROM {} WHERE {} >= x'' LIMIT 1", table, column)).executeStep())
      throw Damage(fmt::format("{} is a BLOB in a row of table {}, expected text", column, table));
  }

  std::vector<Series> series_of(const std::string& study) {
    refuse_blobs("series", "study");
    SQLite::Statement query(
        sqlite, "SELECT key, label, algorithm, options, position FROM series WHERE study = ? ORDER BY position");
    query.bind(1, study);
    std::vector<Series> list;
    while (list.size() <= most_series && query.executeStep()) {  // one too many is enough to be refused
      value_in<std::int64_t>(query.getColumn(4));
      list.push_back({.key = value_in<std::string>(query.getColumn(0)),
                      .label = value_in<std::string>(query.getColumn(1)),
                      .algorithm = value_in<std::string>(query.getColumn(2)),
                      .options = value_in<std::string>(query.getColumn(3))});
    }
    return list;
  }

  std::optional<StudyEntry> find_study(const std::string& name) {
    SQLite::Statement query(sqlite, "SELECT definition FROM studies WHERE name = ?");
    query.bind(1, name);
    if (!query.executeStep()) return std::nullopt;
    StudyEntry study{.name = name, .definition = value_in<std::string>(query.getColumn(0)), .series = series_of(name)};
    check_study(study);
    return study;
  }

  // The names of the studies within a sentence.
  std::string study_names() {
    constexpr std::int64_t most = 20;
    SQLite::Statement query(sqlite, "SELECT name FROM studies ORDER BY position LIMIT ?");
    query.bind(1, most);
    std::vector<std::string> names;
    while (query.executeStep()) names.push_back(value_in<std::string>(query.getColumn(0)));
    const std::int64_t others = number("SELECT count(*) FROM studies") - static_cast<std::int64_t>(names.size());
    if (names.empty()) return "(the store is empty)";
    return fmt::format("{}{}", fmt::join(names, ", "), others > 0 ? fmt::format(" and {} more", others) : "");
  }

  // Appends the solves of a series, up to a run, to the list.
  void read_solves(const std::string& key, std::int64_t last_run, std::vector<SolveRecord>& list) {
    refuse_blobs("solves", "series");
    SQLite::Statement query(sqlite, select_solves());
    query.bind(1, key);
    const int run = query.getColumnIndex("run"), point = query.getColumnIndex("point");
    while (query.executeStep()) {
      try {
        value_in<int>(query.getColumn(point));
        if (value_in<int>(query.getColumn(run)) > last_run) continue;
        SolveRecord& record = list.emplace_back();
        int index = 0;
        for_each_column(
            [&](std::string_view, auto member, std::string_view) { read(query.getColumn(index++), record.*member); });
      } catch (const Damage& error) {
        throw Damage(fmt::format("{}; in the solve of run {}, point {} of series {}", error.what(),
                                 shown(query.getColumn(run)), shown(query.getColumn(point)), shortened(key)));
      }
    }
  }
};

Store::Store(const std::filesystem::path& file, Mode mode)
    : database_(guarded(file.string(), [&] { return std::make_unique<Database>(file, mode); })) {}

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

void Store::save_study(const StudyEntry& study) {
  try {
    check_study(study);
  } catch (const TooManySolves& error) {
    throw std::invalid_argument(error.what());
  } catch (const Damage& error) {
    throw std::logic_error(error.what());
  }

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
    database_->commit(transaction);
  });
}

std::vector<StudyEntry> Store::studies() const {
  return guarded(database_->file, [&] {
    SQLite::Statement query(database_->sqlite, "SELECT name, definition FROM studies ORDER BY position");
    std::vector<StudyEntry> list;
    std::set<std::string> names;
    while (query.executeStep()) {
      const auto name = value_in<std::string>(query.getColumn(0));
      if (!names.insert(name).second) throw Damage(fmt::format("two studies have the name {}", shortened(name)));
      list.push_back({.name = name,
                      .definition = value_in<std::string>(query.getColumn(1)),
                      .series = database_->series_of(name)});
      check_study(list.back());
    }
    return list;
  });
}

StudyEntry Store::study(const std::string& name) const {
  return guarded(database_->file, [&] {
    if (auto found = database_->find_study(name)) return std::move(*found);
    throw std::invalid_argument(
        fmt::format("no study '{}' in '{}', expected one of: {}", name, database_->file, database_->study_names()));
  });
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
    database_->commit(transaction);
    return id;
  });
}

std::vector<Session> Store::sessions() const {
  return guarded(database_->file, [&] {
    SQLite::Statement query(database_->sqlite,
                            "SELECT id, key, value FROM sessions LEFT JOIN environment ON session = id ORDER BY id");
    std::vector<Session> list;
    while (query.executeStep()) {
      const auto id = value_in<std::int64_t>(query.getColumn(0));
      if (list.empty() || list.back().id != id) list.push_back({.id = id, .environment = {}});
      if (!query.getColumn(1).isNull())
        list.back().environment[value_in<std::string>(query.getColumn(1))] = value_in<std::string>(query.getColumn(2));
    }
    SQLite::Statement astray(database_->sqlite, "SELECT session FROM environment WHERE typeof(session) <> 'integer'");
    if (astray.executeStep()) value_in<std::int64_t>(astray.getColumn(0));  // the join passes over it
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
    database_->commit(transaction);
  });
}

std::vector<std::filesystem::path> Store::finish() {
  return guarded(database_->file, [&] {
    database_->fold_with_patience();
    database_->check_place();
    const std::filesystem::path place = std::filesystem::is_symlink(database_->file)
                                            ? std::filesystem::canonical(database_->file)
                                            : std::filesystem::path(database_->file);
    const std::filesystem::path log = place.string() + "-wal";
    std::error_code no_log;
    const auto size = std::filesystem::file_size(log, no_log);
    if (no_log || size == 0) return std::vector{place};
    return std::vector{place, log};
  });
}

std::vector<SolveRecord> Store::series(const std::string& key) const {
  return guarded(database_->file, [&] {
    std::vector<SolveRecord> list;
    database_->read_solves(key, all_runs, list);
    return list;
  });
}

std::map<std::string, std::int64_t> Store::series_of_configuration(std::string_view configuration) const {
  return guarded(database_->file, [&] {
    database_->refuse_blobs("solves", "series");
    SQLite::Statement query(database_->sqlite,
                            "SELECT series, count(*) FROM solves WHERE series = ?1 OR "
                            "(series >= ?2 AND series < ?3) GROUP BY series");
    const std::string first = fmt::format("{}{}", configuration, before_source);
    const std::string beyond = fmt::format("{}{}", configuration, static_cast<char>(before_source + 1));
    SQLite::bind(query, std::string(configuration), first, beyond);
    std::map<std::string, std::int64_t> solves;
    while (query.executeStep()) solves[value_in<std::string>(query.getColumn(0))] = query.getColumn(1).getInt64();
    return solves;
  });
}

std::vector<SolveRecord> Store::solves(const std::string& study_name) const {
  return guarded(database_->file, [&] {
    const StudyEntry entry = study(study_name);
    const std::int64_t runs = check_study(entry);
    std::vector<SolveRecord> list;
    for (const Series& series : entry.series) {
      const std::size_t first = list.size();
      database_->read_solves(series.key, runs, list);
      for (std::size_t i = first; i < list.size(); ++i)
        if (list[i].solver != series.label)
          throw Damage(fmt::format("solver {} in run {}, point {} of the series of {}", shortened(list[i].solver),
                                   list[i].run, list[i].point, shortened(series.label)));
    }
    for (SolveRecord& record : list) record.study = study_name;  // also where another name first solved it
    return list;
  });
}

}  // namespace ikbench::results
