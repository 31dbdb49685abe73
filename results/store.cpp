#include "results/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <chrono>
#include <limits>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "base/files.hpp"
#include "base/inputs.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "results/store_codec.hpp"

namespace ikbench::results {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t application_id = 0x494B424E;  // "IKBN" in the header of the file
constexpr int patience_ms = 10'000;                  // waiting time for a process that has locked the file
constexpr int folding_patience_ms = 5'000;           // waiting time for readers before the log stays

std::string create_tables() {
  return fmt::format(
      "PRAGMA application_id = {}; PRAGMA user_version = {};\n"
      "CREATE TABLE studies (position INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, definition TEXT NOT NULL, "
      "saved TEXT NOT NULL) STRICT;\n"
      "CREATE TABLE series (study TEXT NOT NULL, position INTEGER NOT NULL, key TEXT NOT NULL, label TEXT NOT NULL, "
      "algorithm TEXT NOT NULL, options TEXT NOT NULL, PRIMARY KEY (study, position), UNIQUE (study, key), "
      "UNIQUE (study, label)) STRICT;\n"
      "CREATE TABLE sessions (id INTEGER PRIMARY KEY, began TEXT NOT NULL) STRICT;\n"
      "CREATE TABLE environment (session INTEGER NOT NULL, key TEXT NOT NULL, value TEXT NOT NULL, "
      "PRIMARY KEY (session, key)) STRICT;\n"
      "CREATE TABLE solves ({}, PRIMARY KEY (series, run, point)) STRICT;\n",
      application_id, store_version, solve_declarations());
}

// The table of extras. Only a store whose solves have extras has this table.
constexpr const char* create_extras =
    "CREATE TABLE extras (series TEXT NOT NULL, run INTEGER NOT NULL, point INTEGER NOT NULL, name TEXT NOT NULL, "
    "value REAL, PRIMARY KEY (series, run, point, name)) STRICT, WITHOUT ROWID";

// The tables of known answers. Only a store of a study with solvers that give several answers has these tables.
constexpr const char* create_known_answers =
    "CREATE TABLE known_answers (study TEXT NOT NULL, run INTEGER NOT NULL, point INTEGER NOT NULL, "
    "restarts_key TEXT NOT NULL, known INTEGER NOT NULL, is_continuum INTEGER NOT NULL, restarts_rad TEXT NOT NULL, "
    "PRIMARY KEY (study, run, point)) STRICT, WITHOUT ROWID";
constexpr const char* create_answer_counts =
    "CREATE TABLE answer_counts (study TEXT NOT NULL, series TEXT NOT NULL, run INTEGER NOT NULL, point INTEGER NOT NULL, "
    "given INTEGER NOT NULL, found INTEGER NOT NULL, wrong INTEGER NOT NULL, doubled INTEGER NOT NULL, "
    "PRIMARY KEY (study, series, run, point)) STRICT, WITHOUT ROWID";

// Returns views for readers who query the file without ikbench.
std::string create_views() {
  std::string columns = solve_columns();
  columns.replace(columns.find("study, robot, label,"), std::string_view("study, robot, label,").size(),
                  "studies.name AS study, robot, series.label AS label,");
  return fmt::format(
      "CREATE VIEW current_solves AS SELECT {} FROM studies JOIN series ON series.study = studies.name "
      "JOIN solves ON solves.series = series.key "
      "WHERE run <= json_extract(definition, '$.runs') AND point <= json_extract(definition, '$.points');\n"
      "CREATE VIEW run_means AS SELECT study, label, run, count(*) AS solves, "
      "avg(status = 'ok') AS solved, avg(position_error_cm) AS position_error_cm, "
      "avg(orientation_error) AS orientation_error, avg(variation_deg) AS variation_deg, avg(seconds) AS seconds, "
      "avg(iif(counted_by = 'none', NULL, evaluations)) AS evaluations "
      "FROM current_solves GROUP BY study, label, run;\n",
      columns);
}

// The tables, each with the columns that give its rows one order.
constexpr std::pair<std::string_view, std::string_view> ordered_tables[] = {
    {"studies", "position"},
    {"series", "study, position"},
    {"sessions", "id"},
    {"environment", "session, key"},
    {"solves", "series, run, point"},
    {"extras", "series, run, point, name"},
    {"known_answers", "study, run, point"},
    {"answer_counts", "study, series, run, point"}};

// Returns the bytes of a number, the same on every machine.
std::string bytes_of(std::uint64_t number) {
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(number >> (8 * i));
  return bytes;
}

// Returns a value with its type, and a text with its length, so that no two rows have the same bytes.
std::string bytes_of(const SQLite::Column& value) {
  switch (value.getType()) {
    case SQLITE_INTEGER:
      return "i" + bytes_of(static_cast<std::uint64_t>(value.getInt64()));
    case SQLITE_FLOAT:
      return "r" + bytes_of(std::bit_cast<std::uint64_t>(value.getDouble()));
    case SQLITE_NULL:
      return "n";
    default: {
      const std::string text = value.getString();
      return "t" + bytes_of(text.size()) + text;
    }
  }
}

// Returns the SQL text of all tables and views that every store has, letter by letter.
std::string schema_of(SQLite::Database& sqlite) {
  return sqlite
      .execAndGet(fmt::format(
          "SELECT group_concat(concat, char(10)) FROM (SELECT type || name || tbl_name || coalesce(sql, '') AS concat "
          "FROM sqlite_master WHERE coalesce(sql, '') NOT IN ('{}', '{}', '{}') ORDER BY name)",
          create_extras, create_known_answers, create_answer_counts))
      .getString();
}

std::string our_schema() {
  SQLite::Database empty(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  empty.exec(create_tables() + create_views());
  return schema_of(empty);
}

// Returns whether the system makes the file while a program reads, as /proc/kmsg: the size is 0, but there are bytes.
// SQLite would wait for the first bytes for ever.
bool is_made_by_reading(const fs::path& path) {
  std::error_code none;
  const auto says_to_be_empty = [&] { return fs::file_size(path, none) == 0 && !none; };
  if (!says_to_be_empty()) return false;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  char first = 0;
  const bool is_empty = ::read(descriptor, &first, 1) == 0;
  ::close(descriptor);
  return !is_empty && says_to_be_empty();  // if the size is no longer 0, another process has just begun the store
}

// Returns the path for SQLite, which is absolute so that no name has a special meaning (":memory:").
std::string checked_path(const fs::path& file, Store::Mode mode) {
  std::error_code error;
  const fs::path path = fs::absolute(file, error);
  const fs::file_status status = fs::status(path, error);
  if (file.empty() || fs::is_directory(status))
    throw std::invalid_argument(fmt::format("'{}' is a folder; expected a store, such as '{}'", file.string(),
                                            (file / "store.sqlite").string()));
  if (fs::exists(status) && (!fs::is_regular_file(status) || is_made_by_reading(path)))
    throw std::invalid_argument(fmt::format("'{}' is not a regular file; expected a store", file.string()));
  if (mode != Store::Mode::read && fs::is_symlink(path, error))
    throw std::invalid_argument(fmt::format("'{}' is a link; name the store that it leads to", file.string()));
  if (mode == Store::Mode::read && status.type() == fs::file_type::not_found)
    throw std::invalid_argument(
        fmt::format("'{}' does not exist; expected a store, which `ikbench run` writes", file.string()));
  if (mode != Store::Mode::read) fs::create_directories(path.parent_path(), error);
  if (mode != Store::Mode::read && error) base::refuse_place("write", file, error.value());
  return path.string();
}

[[noreturn]] void refuse(const std::string& file, const CorruptValue& damage) {
  throw std::invalid_argument(
      fmt::format("'{}' is damaged ({}); restore a copy, or run its studies into a new store", file, damage.what()));
}

[[noreturn]] void refuse_taken_away(const std::string& file) {
  throw std::runtime_error(
      fmt::format("'{}' was removed, moved or replaced while ikbench wrote to it, so it lacks the new solves; if you "
                  "moved it, move it back; then run again",
                  file));
}

// Returns true if the file system has no locks, as a network file system without a lock daemon. SQLite reports missing
// locks as busy.
bool lacks_locks(const std::string& file) {
  struct flock anything {};
  anything.l_type = F_RDLCK;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool lacks = descriptor >= 0 && ::fcntl(descriptor, F_GETLK, &anything) != 0 && errno == ENOLCK;
  if (descriptor >= 0) ::close(descriptor);
  return lacks;
}

// Throws `error` as a sentence about the file. store.hpp says which exception means what.
[[noreturn]] void refuse(const std::string& file, const SQLite::Exception& error) {
  // SQLite also reports damage if the system fails to read a page.
  for (const int code : {error.getErrorCode(), error.getExtendedErrorCode()})
    if (code == SQLITE_IOERR_READ || code == SQLITE_IOERR_CORRUPTFS || (code == SQLITE_CORRUPT && errno == EIO))
      base::refuse_place("read", file, EIO);
  switch (error.getErrorCode() & 0xff) {
    case SQLITE_NOTADB:
      throw std::invalid_argument(fmt::format(
          "'{}' is not an ikbench store: it is not an SQLite file; expected a file written by ikbench", file));
    case SQLITE_CONSTRAINT:
      if (error.getExtendedErrorCode() == SQLITE_CONSTRAINT_PRIMARYKEY)
        throw std::invalid_argument(fmt::format(
            "another ikbench is running the same study into '{}'; wait until it has ended, then run again", file));
      [[fallthrough]];
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // the SQL of ikbench is right, so the tables are wrong
      refuse(file, CorruptValue(error.what()));
    case SQLITE_READONLY:
      if (error.getExtendedErrorCode() == SQLITE_READONLY_DBMOVED) refuse_taken_away(file);
      if (error.getExtendedErrorCode() == SQLITE_READONLY_ROLLBACK)
        throw InterruptedWrite(fmt::format(
            "'{}' is half-written, because ikbench was killed or its disk failed; keep '{}-journal' beside it and "
            "repeat the command that wrote it, which undoes the unfinished write and continues",
            file, file));
      [[fallthrough]];
    case SQLITE_CANTOPEN:
      if (errno == EMFILE || errno == EIO) base::refuse_place("read", file, errno);
      try {  // SQLite does not say why opening failed; a full disk also refuses a new folder
        base::TemporaryFolder(fs::absolute(file).parent_path(), file);
      } catch (const std::invalid_argument&) {
      }
      [[fallthrough]];
    case SQLITE_PERM:
      throw std::invalid_argument(fmt::format(
          "cannot open '{}' ({}): you may not read or write the file, its folder or the '-wal' file beside it; change "
          "the permissions, or copy the store with its '-wal' file to a folder where you can write",
          file, error.what()));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      if (lacks_locks(file))
        throw std::invalid_argument(fmt::format(
            "cannot use '{}': this folder's file system has no locks; choose another with --out, or copy the store there",
            file));
      throw std::runtime_error(
          fmt::format("another process has locked '{}'; wait until it has ended, then run again", file));
    case SQLITE_NOMEM:
      throw std::bad_alloc();
    default:  // a full disk, a limit of files, a fault of the disk
      throw std::runtime_error(fmt::format(
          "cannot use '{}': {}; make room on its disk, raise ulimit -f or take another disk; then run again", file,
          error.what()));
  }
}

// Executes a statement that returns nothing. The statement can be executed again.
template <class... Values>
void execute(SQLite::Statement& statement, const Values&... values) {
  SQLite::bind(statement, values...);
  statement.exec();
  statement.reset();
}

std::string name_of_extra(const SQLite::Column& column) {
  const std::string name = column.getString();
  if (!base::is_plain(name)) throw CorruptValue(fmt::format("{} as the name of an extra", base::in_quotes(name)));
  return name;
}

// Calls `action` and returns the result. Throws as `refuse` if SQLite fails or finds damage.
template <class Action>
auto guarded(const std::string& file, Action&& action) {
  errno = 0;  // SQLite sets errno where a call fails
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    refuse(file, error);
  } catch (const CorruptValue& damage) {
    refuse(file, damage);
  }
}

}  // namespace

struct Store::Database {
  Database(const fs::path& file, Mode how)
      : name(file.string()),
        mode(how),
        sqlite(checked_path(file, mode),
               (mode == Mode::read ? SQLite::OPEN_READONLY : SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) |
                   SQLite::OPEN_NOMUTEX,  // a store belongs to one thread at a time
               patience_ms),
        identity(identity_there()) {
    for (const char* part : {"", "-wal", "-shm", "-journal"}) base::note_input(name + part);
    if (mode != Mode::read) sqlite.exec("PRAGMA page_size = 16384");  // applies to a new file; fewer pages are faster
    using enum SQLite::TransactionBehavior;
    SQLite::Transaction transaction(sqlite, mode == Mode::read ? DEFERRED : IMMEDIATE);
    const bool is_new = number("SELECT count(*) FROM sqlite_master") == 0 && number("PRAGMA application_id") == 0;
    if (mode != Mode::read && is_new) sqlite.exec(create_tables() + create_views());
    check_file();
    transaction.commit();
    if (mode == Mode::write) keep_journal("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
    if (mode == Mode::write_shared) keep_journal("PRAGMA journal_mode = DELETE");
  }
  ~Database() {
    if (mode == Mode::write) fold(0);
  }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  // Sets the journal. If another process changes the journal at the same time, SQLite is busy at once, whatever the
  // timeout, so this function waits instead.
  void keep_journal(const char* statements) {
    for (int waited_ms = 0;; waited_ms += 10) {
      const int code = sqlite.tryExec(statements);
      if (code == SQLITE_OK) return;
      if (code != SQLITE_BUSY || waited_ms >= patience_ms) throw SQLite::Exception(sqlite.getHandle(), code);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  std::int64_t number(const char* query) { return sqlite.execAndGet(query).getInt64(); }

  void check_file() {
    if (fs::file_size(name) == 0 && number("PRAGMA page_count") == 0)
      throw InterruptedWrite(fmt::format(
          "'{}' is not an ikbench store yet: it is empty, because ikbench was killed when it began or its disk failed; "
          "repeat the command that wrote it, which continues it",
          name));
    if (number("PRAGMA application_id") != application_id)
      throw std::invalid_argument(fmt::format(
          "'{}' is not an ikbench store: another program wrote it; expected a file written by ikbench", name));
    if (const std::int64_t version = number("PRAGMA user_version"); version != store_version)
      throw std::invalid_argument(
          fmt::format("'{}' is a store of version {}, but this ikbench reads only version {}; read it with the ikbench "
                      "that made it, or run its studies into a new store",
                      name, version, store_version));
    // SQLite reads missing bytes of the last page as zeros, so the size is checked. A kill while the log is folded in
    // may leave half a page, which is no damage if the log still has that page.
    const auto size = fs::file_size(name), page = static_cast<std::uintmax_t>(number("PRAGMA page_size"));
    if (size % page != 0 && !log_has(size / page + 1, page)) throw CorruptValue("it is truncated");
    // Foreign tables and views are refused, because a view may be endless, and a column may be computed.
    if (schema_of(sqlite) != our_schema()) throw CorruptValue("its tables and views are not those that ikbench makes");
    std::string verdict = sqlite.execAndGet("PRAGMA quick_check(1)").getString();
    verdict.erase(0, verdict.rfind('\n') + 1);
    constexpr std::string_view unread = "unable to get the page. error code=";
    if (const auto at = verdict.find(unread); at != std::string::npos)
      throw SQLite::Exception(verdict, std::stoi(verdict.substr(at + unread.size())));
    if (verdict != "ok") throw CorruptValue(verdict);
  }

  // Returns true if the log has this page, counted from 1, because SQLite then reads the page from the log. The log is
  // 32 bytes, then frames of 24 bytes and a page; valid frames repeat the salt of the first 32 bytes
  // (sqlite.org/walformat.html).
  bool log_has(std::uintmax_t page, std::size_t page_size) const {
    const std::string log = base::read_file(name + "-wal").value_or("");
    for (std::size_t frame = 32; frame + 24 + page_size <= log.size(); frame += 24 + page_size) {
      std::uintmax_t logged_page = 0;
      for (std::size_t i = 0; i < 4; ++i) logged_page = 256 * logged_page + static_cast<unsigned char>(log[frame + i]);
      if (logged_page == page && log.compare(frame + 8, 8, log, 16, 8) == 0) return true;
    }
    return false;
  }

  // Returns the device and number of the file that is now at the path.
  std::optional<std::pair<dev_t, ino_t>> identity_there() const {
    struct stat status {};
    if (::stat(sqlite.getFilename().c_str(), &status) != 0) return std::nullopt;
    return std::pair(status.st_dev, status.st_ino);
  }
  // Returns false if the file was unlinked or moved away. SQLite would continue to write into the lost file.
  bool is_in_place() const { return identity && identity_there() == identity; }
  void check_place() const {
    if (!is_in_place()) refuse_taken_away(name);
  }

  template <class Action>
  void write(Action&& action) {
    guarded(name, [&] {
      SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
      action();
      transaction.commit();
      check_place();
    });
  }

  // Folds the log into the file, unless another process continues to read or write. Even then the committed data are
  // safe, and the next writer folds the log in.
  void fold(int wait_ms) {
    sqlite.setBusyTimeout(wait_ms);
    sqlite.tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
    // If the file is no longer at the path, a change of the journal would remove the log of another file. In the
    // second try, the read undoes a change that failed half-way.
    for (int tries = 0; tries < 2 && is_in_place(); ++tries)
      if (sqlite.tryExec("SELECT 1 FROM sqlite_master; PRAGMA journal_mode = DELETE") != SQLITE_IOERR) break;
    sqlite.setBusyTimeout(patience_ms);
  }

  void add_environment(std::int64_t session, const std::map<std::string, std::string>& environment) {
    SQLite::Statement add(sqlite, "INSERT INTO environment (session, key, value) VALUES (?, ?, ?)");
    for (const auto& [key, value] : environment) execute(add, session, key, value);
  }

  // Calls `take` with each solve of a query.
  void read_solves(SQLite::Statement& query, const RecordConsumer& take) {
    SolveRecord solve;  // one record for all solves, so that its lists keep their memory
    std::optional<SQLite::Statement> extras;
    if (sqlite.tableExists("extras"))
      extras.emplace(sqlite, "SELECT name, value FROM extras WHERE series = ? AND run = ? AND point = ?");
    while (query.executeStep()) {
      try {
        read_solve(query, solve);
        solve.extras.clear();
        if (extras) {
          extras->reset();
          for (SQLite::bind(*extras, solve.series, solve.run, solve.point); extras->executeStep();)
            solve.extras[name_of_extra(extras->getColumn(0))] = extras->getColumn(1).isNull()
                                                                    ? std::numeric_limits<double>::quiet_NaN()
                                                                    : extras->getColumn(1).getDouble();
        }
      } catch (const CorruptValue& error) {
        throw CorruptValue(fmt::format("{}; in the solve of run {}, point {} of series {}", error.what(),
                                       query.getColumn("run").getString(), query.getColumn("point").getString(),
                                       base::in_quotes(query.getColumn("series").getString())));
      }
      take(solve);
    }
  }

  // Writes a study in place of one of the same name. Called inside a transaction.
  void save_study(const StoredStudy& study) {
    SQLite::Statement save(
        sqlite,
        "INSERT INTO studies (name, definition, saved) VALUES (?1, ?2, strftime('%Y-%m-%dT%H:%M:%SZ', 'now')) "
        "ON CONFLICT (name) DO UPDATE SET definition = excluded.definition, saved = excluded.saved");
    execute(save, study.name, study.definition.json);
    SQLite::Statement clear(sqlite, "DELETE FROM series WHERE study = ?");
    execute(clear, study.name);
    SQLite::Statement add(
        sqlite, "INSERT INTO series (study, position, key, label, algorithm, options) VALUES (?, ?, ?, ?, ?, ?)");
    std::int64_t position = 0;
    for (const Series& series : study.series)
      execute(add, study.name, ++position, series.key, series.label, series.algorithm, series.options);
  }

  // Removes a study, but none of its solves. Called inside a transaction.
  void remove_study(const std::string& study) {
    for (const char* const sql : {"DELETE FROM series WHERE study = ?", "DELETE FROM studies WHERE name = ?"}) {
      SQLite::Statement remove(sqlite, sql);
      execute(remove, study);
    }
  }

  const std::string name;  // as the user gave it
  const Mode mode;
  SQLite::Database sqlite;
  const std::optional<std::pair<dev_t, ino_t>> identity;  // identity of the file that was opened
  std::optional<SolveInsert> insert;                      // made with the first solve
};

Store::Store(const fs::path& file, Mode mode)
    : database_(guarded(file.string(), [&] { return std::make_unique<Database>(file, mode); })) {}

Store::~Store() = default;

void Store::save_study(const StoredStudy& study) {
  database_->write([&] { database_->save_study(study); });
}

void Store::save_sweep(const std::vector<StoredStudy>& studies) {
  const std::vector<StoredStudy> earlier = sweep(studies.front().definition.sweep.name);
  database_->write([&] {
    for (const StoredStudy& study : earlier) database_->remove_study(study.name);
    for (const StoredStudy& study : studies) database_->save_study(study);
  });
}

std::vector<StoredStudy> Store::studies(const std::string& name) const {
  return guarded(database_->name, [&] {
    SQLite::Statement query(database_->sqlite,
                            "SELECT name, definition FROM studies WHERE ? IN ('', name) ORDER BY position");
    SQLite::Statement of_study(database_->sqlite,
                               "SELECT key, label, algorithm, options FROM series WHERE study = ? ORDER BY position");
    std::vector<StoredStudy> list;
    const auto object = [](SQLite::Column column) {
      if (!base::parsed_json(column.getString()).is_object())
        throw CorruptValue(
            fmt::format("{} {} is not a JSON object", column.getName(), base::in_quotes(column.getString())));
      return column.getString();
    };
    for (query.bind(1, name); query.executeStep();) {
      StoredStudy study{.name = query.getColumn(0).getString(), .definition = {}, .series = {}};
      try {
        study.definition = parse_definition(object(query.getColumn(1)));
      } catch (const FormerDefinition& error) {
        throw std::invalid_argument(fmt::format(
            "'{}' was written by an earlier ikbench ({}); run its study again into a new folder: ikbench run STUDY --out "
            "NEW",
            database_->name, error.what()));
      } catch (const std::invalid_argument& error) {
        throw CorruptValue(error.what());
      }
      for (of_study.bind(1, study.name); of_study.executeStep();)
        study.series.push_back({.key = of_study.getColumn(0).getString(),
                                .label = of_study.getColumn(1).getString(),
                                .algorithm = of_study.getColumn(2).getString(),
                                .options = object(of_study.getColumn(3))});
      of_study.reset();
      if (study.series.size() > max_solvers)
        throw CorruptValue(fmt::format("study {} has more than {} solvers", base::in_quotes(study.name), max_solvers));
      list.push_back(std::move(study));
    }
    return list;
  });
}

StoredStudy Store::study(const std::string& name) const {
  std::vector<std::string> names;
  guarded(database_->name, [&] {
    SQLite::Statement query(database_->sqlite, "SELECT name FROM studies ORDER BY position");
    while (query.executeStep()) names.push_back(query.getColumn(0).getString());
  });
  if (names.empty())
    throw std::invalid_argument(
        fmt::format("'{}' has no study; expected a store that `ikbench run` wrote", database_->name));
  if (!name.empty() && std::ranges::find(names, name) == names.end())
    throw std::invalid_argument(fmt::format("there is no study '{}' in '{}'; expected one of: {}", name,
                                            database_->name, fmt::join(names, ", ")));
  StoredStudy found = studies(name.empty() ? names.front() : name).front();
  if (name.empty() && !found.definition.sweep.name.empty())
    throw std::invalid_argument(fmt::format("'{}' has the sweep {}; name one of its studies, such as --study {}",
                                            database_->name, found.definition.sweep.name, base::in_quotes(found.name)));
  return found;
}

std::vector<StoredStudy> Store::sweep(const std::string& name) const {
  std::vector<StoredStudy> all = studies();
  if (all.empty()) return {};
  const std::string wanted = name.empty() ? all.front().definition.sweep.name : name;
  std::erase_if(all, [&](const StoredStudy& study) { return study.definition.sweep.name != wanted; });
  if (wanted.empty()) all.clear();
  return all;
}

void Store::save_counted_answers(const std::string& study, const CountedAnswers& counted) {
  database_->write([&] {
    SQLite::Database& sqlite = database_->sqlite;
    if (!sqlite.tableExists("known_answers")) sqlite.exec(create_known_answers);
    if (!sqlite.tableExists("answer_counts")) sqlite.exec(create_answer_counts);
    for (const char* const sql :
         {"DELETE FROM known_answers WHERE study = ?", "DELETE FROM answer_counts WHERE study = ?"}) {
      SQLite::Statement remove(sqlite, sql);
      execute(remove, study);
    }
    SQLite::Statement add_target(sqlite, "INSERT INTO known_answers VALUES (?, ?, ?, ?, ?, ?, ?)");
    for (const KnownAnswers& target : counted.targets)
      execute(add_target, study, target.run, target.point, counted.restarts_key, target.known,
              static_cast<int>(target.is_continuum), text_of_list(target.restarts_rad));
    SQLite::Statement add_count(sqlite, "INSERT INTO answer_counts VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    for (const AnswerCount& count : counted.counts)
      execute(add_count, study, count.series, count.run, count.point, count.given, count.found, count.wrong,
              count.doubled);
  });
}

namespace {

// Returns a number of answers, which no store of ours has larger.
int number_of_answers(const SQLite::Column& column) {
  constexpr std::int64_t max_answers = 10'000'000;
  const std::int64_t number = column.getInt64();
  if (number < 0 || number > max_answers) throw CorruptValue(fmt::format("{} is {}", column.getName(), number));
  return static_cast<int>(number);
}

}  // namespace

CountedAnswers Store::counted_answers(const std::string& study) const {
  return guarded(database_->name, [&] {
    CountedAnswers counted;
    SQLite::Database& sqlite = database_->sqlite;
    if (!sqlite.tableExists("known_answers") || !sqlite.tableExists("answer_counts")) return counted;
    SQLite::Statement targets(sqlite, "SELECT * FROM known_answers WHERE study = ? ORDER BY run, point");
    for (targets.bind(1, study); targets.executeStep();) {
      counted.restarts_key = targets.getColumn("restarts_key").getString();
      counted.targets.push_back({.run = number_of_answers(targets.getColumn("run")),
                                 .point = number_of_answers(targets.getColumn("point")),
                                 .known = number_of_answers(targets.getColumn("known")),
                                 .is_continuum = targets.getColumn("is_continuum").getInt() != 0,
                                 .restarts_rad = list_in_text(targets.getColumn("restarts_rad").getString())});
    }
    SQLite::Statement counts(sqlite, "SELECT * FROM answer_counts WHERE study = ? ORDER BY series, run, point");
    for (counts.bind(1, study); counts.executeStep();)
      counted.counts.push_back({.series = counts.getColumn("series").getString(),
                                .run = number_of_answers(counts.getColumn("run")),
                                .point = number_of_answers(counts.getColumn("point")),
                                .given = number_of_answers(counts.getColumn("given")),
                                .found = number_of_answers(counts.getColumn("found")),
                                .wrong = number_of_answers(counts.getColumn("wrong")),
                                .doubled = number_of_answers(counts.getColumn("doubled"))});
    return counted;
  });
}

std::int64_t Store::begin_session(const std::map<std::string, std::string>& environment) {
  std::int64_t id = 0;
  database_->write([&] {
    database_->sqlite.exec("INSERT INTO sessions (began) VALUES (strftime('%Y-%m-%dT%H:%M:%SZ', 'now'))");
    id = database_->sqlite.getLastInsertRowid();
    database_->add_environment(id, environment);
  });
  return id;
}

void Store::add_to_session(std::int64_t id, const std::map<std::string, std::string>& environment) {
  database_->write([&] { database_->add_environment(id, environment); });
}

std::vector<Session> Store::sessions() const {
  return guarded(database_->name, [&] {
    SQLite::Statement query(
        database_->sqlite,
        "SELECT id, key, value, began FROM sessions LEFT JOIN environment ON session = id ORDER BY id");
    std::vector<Session> list;
    while (query.executeStep()) {
      const std::int64_t id = query.getColumn(0).getInt64();
      if (list.empty() || list.back().id != id) list.push_back({.id = id, .began = query.getColumn(3).getString()});
      if (!query.getColumn(1).isNull())
        list.back().environment[query.getColumn(1).getString()] = query.getColumn(2).getString();
    }
    return list;
  });
}

void Store::append(const std::vector<SolveRecord>& records) {
  database_->write([&] {
    if (!database_->insert) database_->insert.emplace(database_->sqlite);
    for (const SolveRecord& record : records) {
      (*database_->insert)(record);
      if (record.extras.empty()) continue;
      if (!database_->sqlite.tableExists("extras")) database_->sqlite.exec(create_extras);
      SQLite::Statement add(database_->sqlite, "INSERT INTO extras VALUES (?, ?, ?, ?, ?)");
      for (const auto& [name, value] : record.extras)
        execute(add, record.series, record.run, record.point, name, value);  // a NaN becomes NULL
    }
  });
}

std::vector<fs::path> Store::close() {
  return guarded(database_->name, [&]() -> std::vector<fs::path> {
    if (database_->mode == Mode::write) database_->fold(folding_patience_ms);
    database_->check_place();
    const fs::path place = database_->name, log = place.string() + "-wal";
    std::error_code no_log;
    const auto size = fs::file_size(log, no_log);
    if (no_log || size == 0) return {place};
    return {place, log};
  });
}

void Store::merge_from(const fs::path& source, const std::function<void(SQLite::Database&)>& action) {
  SQLite::Database& sqlite = database_->sqlite;
  std::string blamed = database_->name;
  try {
    {
      SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
      SQLite::Statement attach(sqlite, "ATTACH ? AS source");  // now, so that the transaction locks only this store
      attach.bind(1, fs::absolute(source).string());
      blamed = source.string();
      attach.exec();
      action(sqlite);
      blamed = database_->name;
      transaction.commit();
    }
    database_->check_place();
    sqlite.exec("DETACH source");
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode();
    if (code == SQLITE_CONSTRAINT) refuse(source.string(), CorruptValue(error.what()));
    const bool is_of_writing = code == SQLITE_FULL || code == SQLITE_READONLY || code == SQLITE_IOERR;
    refuse(is_of_writing ? database_->name : blamed, error);
  }
}

void Store::each_value(std::string_view left_out, const std::function<void(std::string_view)>& take) const {
  guarded(database_->name, [&] {
    for (const auto& [table, keys] : ordered_tables) {
      if (!database_->sqlite.tableExists(std::string(table))) continue;  // a store without extras has no such table
      const bool has_facts = table == "environment";
      SQLite::Statement rows(database_->sqlite, fmt::format("SELECT * FROM {}{} ORDER BY {}", table,
                                                            has_facts ? " WHERE key <> ?" : "", keys));
      if (has_facts) rows.bind(1, std::string(left_out));
      take(table);
      while (rows.executeStep()) {
        std::string bytes = "row";
        for (int column = 0; column < rows.getColumnCount(); ++column) bytes += bytes_of(rows.getColumn(column));
        take(bytes);
      }
    }
  });
}

void Store::in_snapshot(const std::function<void()>& action) const {
  guarded(database_->name, [&] {
    SQLite::Transaction transaction(database_->sqlite);
    action();
    transaction.commit();
  });
}

void Store::for_each_in_series(const std::string& key, const RecordConsumer& take) const {
  guarded(database_->name, [&] {
    SQLite::Statement query(database_->sqlite,
                            fmt::format("SELECT {} FROM solves WHERE series = ? ORDER BY run, point", solve_columns()));
    query.bind(1, key);
    database_->read_solves(query, take);
  });
}

std::vector<std::string> Store::extra_names(const StoredStudy& study) const {
  return guarded(database_->name, [&] {
    std::vector<std::string> names;
    if (!database_->sqlite.tableExists("extras")) return names;
    SQLite::Statement query(
        database_->sqlite,
        "SELECT DISTINCT name FROM extras JOIN series ON key = extras.series WHERE study = ? ORDER BY name");
    for (query.bind(1, study.name); query.executeStep();) names.push_back(name_of_extra(query.getColumn(0)));
    return names;
  });
}

std::int64_t Store::stale_solve_count(std::string_view series) const {
  return guarded(database_->name, [&] {
    SQLite::Statement query(database_->sqlite,
                            "SELECT count(*) FROM solves WHERE series >= ? AND series < ? AND series <> ?");
    const std::string configuration(configuration_part(series));
    SQLite::bind(query, configuration + source_separator, configuration + static_cast<char>(source_separator + 1),
                 std::string(series));
    query.executeStep();
    return query.getColumn(0).getInt64();
  });
}

void Store::for_each_in_study(const StoredStudy& study, const RecordConsumer& take) const {
  guarded(database_->name, [&] {
    SQLite::Statement query(
        database_->sqlite,
        fmt::format("SELECT {} FROM solves WHERE series = ? AND run <= ? AND point <= ? ORDER BY run, point",
                    solve_columns()));
    for (const Series& series : study.series) {
      SQLite::bind(query, series.key, study.definition.runs, study.definition.points);
      database_->read_solves(query, [&](SolveRecord& record) {
        if (record.label != series.label)
          throw CorruptValue(fmt::format("the label of {} differs in its solves", base::in_quotes(series.label)));
        record.study = study.name;  // a solve has the name of the study that solved it first
        take(record);
      });
      query.reset();
    }
  });
}

std::int64_t Store::solve_count(const StoredStudy& study) const {
  return guarded(database_->name, [&] {
    SQLite::Statement query(database_->sqlite,
                            "SELECT count(*) FROM solves WHERE series = ? AND run <= ? AND point <= ?");
    std::int64_t solves = 0;
    for (const Series& series : study.series) {
      SQLite::bind(query, series.key, study.definition.runs, study.definition.points);
      query.executeStep();
      solves += query.getColumn(0).getInt64();
      query.reset();
    }
    return solves;
  });
}

}  // namespace ikbench::results
