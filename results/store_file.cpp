#include "results/store_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace ikbench::results {
namespace {

constexpr std::int64_t application_id = 0x494B424E;  // "IKBN" in the header of the file
constexpr int busy_timeout_ms = 10'000;
constexpr std::chrono::seconds folding_patience{5};
constexpr int largest_value = 256'000'000;  // bytes of a text in the file; more than any study needs

[[noreturn]] void refuse_taken_away(const std::string& file) {
  throw std::runtime_error(
      fmt::format("'{}' was removed, moved or replaced while ikbench wrote to it, so it lacks the new solves; if you "
                  "moved it, move it back; then run again",
                  file));
}

std::string create_tables() {
  return fmt::format(
      "PRAGMA application_id = {}; PRAGMA user_version = {};\n"
      "CREATE TABLE studies (position INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, definition TEXT NOT NULL, "
      "saved TEXT NOT NULL);\n"
      "CREATE TABLE series (study TEXT NOT NULL, position INTEGER NOT NULL, key TEXT NOT NULL, label TEXT NOT NULL, "
      "algorithm TEXT NOT NULL, options TEXT NOT NULL, PRIMARY KEY (study, position), UNIQUE (study, key), "
      "UNIQUE (study, label));\n"
      "CREATE TABLE sessions (id INTEGER PRIMARY KEY, began TEXT NOT NULL);\n"
      "CREATE TABLE environment (session INTEGER NOT NULL, key TEXT NOT NULL, value TEXT NOT NULL, "
      "PRIMARY KEY (session, key));\n{};\n",
      application_id, store_version, create_solves());
}

// ", such as 'out/mine/store.sqlite'": stores in a folder and in the folders in it; empty if there are none.
std::string stores_in(const std::filesystem::path& folder) {
  constexpr std::size_t most = 5;
  std::vector<std::string> found;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator entry(folder, error), end; entry != end; entry.increment(error)) {
    if (entry.depth() > 0) entry.disable_recursion_pending();
    if (entry->path().extension() == ".sqlite") found.push_back(fmt::format("'{}'", entry->path().string()));
  }
  std::ranges::sort(found);
  found.resize(std::min(found.size(), most));
  return found.empty() ? "" : fmt::format(", such as {}", fmt::join(found, ", "));
}

// The path for SQLite, absolute so that it has no special meaning (":memory:").
std::string checked_path(const std::filesystem::path& file, Store::Mode mode) {
  std::error_code error;
  const auto path = std::filesystem::absolute(file, error);
  const auto status = std::filesystem::status(path, error);
  if (file.empty() || std::filesystem::is_directory(status))
    throw std::invalid_argument(
        fmt::format("'{}' is a folder; expected a store file{}", file.string(), stores_in(file)));
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw std::invalid_argument(fmt::format("'{}' is not a regular file; expected a store file", file.string()));
  if (mode == Store::Mode::read && status.type() == std::filesystem::file_type::not_found)
    throw std::invalid_argument(
        fmt::format("'{}' does not exist; expected a store, which `ikbench run` writes", file.string()));
  if (mode != Store::Mode::read) {
    std::filesystem::create_directories(path.parent_path(), error);
    if (error)
      throw std::invalid_argument(fmt::format(
          "cannot write '{}': its folder cannot be created ({}); choose another path", file.string(), error.message()));
  }
  return path.string();
}

}  // namespace

void refuse(const std::string& file, const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      throw std::invalid_argument(fmt::format(
          "'{}' is not an ikbench store: it is not an SQLite file; expected a file written by ikbench", file));
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // our SQL is right, so the tables are wrong
      refuse(file, Damage(error.what()));
    case SQLITE_TOOBIG:
      throw std::invalid_argument(
          fmt::format("'{}' cannot store a value of more than {} MB; expected a shorter text, list or trace", file,
                      largest_value / 1'000'000));
    case SQLITE_READONLY:
      if (error.getExtendedErrorCode() == SQLITE_READONLY_DBMOVED) refuse_taken_away(file);
      if (error.getExtendedErrorCode() == SQLITE_READONLY_ROLLBACK)
        throw HalfWritten(fmt::format(
            "'{}' is half-written, because ikbench was killed; keep '{}-journal' beside it and give the command that "
            "was killed again, which undoes the unfinished write and continues",
            file, file));
      [[fallthrough]];
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      throw std::invalid_argument(fmt::format(
          "cannot open '{}' ({}): you may not read or write the file, its folder or the '-wal' file beside it; change "
          "the permissions, or copy the store with its '-wal' file to a folder where you can write",
          file, error.what()));
    case SQLITE_FULL:
      throw std::runtime_error(fmt::format("cannot use '{}': {}; make room on its disk and give the same command again",
                                           file, error.what()));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw std::runtime_error(fmt::format("another process has kept '{}' locked for {} s; wait until it has ended",
                                           file, busy_timeout_ms / 1000));
    case SQLITE_CONSTRAINT:
      if (error.getExtendedErrorCode() != SQLITE_CONSTRAINT_PRIMARYKEY) {
        throw std::logic_error(fmt::format("'{}' already has this row: {}", file, error.what()));
      }
      throw std::invalid_argument(fmt::format(
          "another ikbench is running the same study into '{}'; wait until it has ended, then run again", file));
    default:
      throw std::runtime_error(fmt::format("cannot use '{}': {}", file, error.what()));
  }
}

void refuse(const std::string& file, const Damage& damage) {
  throw std::invalid_argument(
      fmt::format("'{}' is damaged ({}); restore a copy, or run its studies into a new store", file, damage.what()));
}

std::optional<StoreFile::Identity> StoreFile::identity_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return Identity{status.st_dev, status.st_ino};
}

StoreFile::StoreFile(const std::filesystem::path& path, Store::Mode mode)
    : name_(path.string()),
      mode_(mode),
      sqlite_(checked_path(path, mode),
              (mode == Store::Mode::read ? SQLite::OPEN_READONLY : SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) |
                  SQLite::OPEN_NOMUTEX |  // a store belongs to one thread at a time
                  SQLite::OPEN_URI,       // for attached files; this path begins with a slash
              busy_timeout_ms),
      identity_(identity_of(sqlite_.getFilename())) {
  distrust();
  using enum SQLite::TransactionBehavior;
  SQLite::Transaction transaction(sqlite_, mode == Store::Mode::read ? DEFERRED : IMMEDIATE);
  if (mode != Store::Mode::read && number("SELECT count(*) FROM sqlite_master") == 0 &&
      number("PRAGMA application_id") == 0)
    sqlite_.exec(create_tables());
  check_header();
  check_tables();
  check_pages();
  transaction.commit();
  if (mode == Store::Mode::read) return;
  if (mode == Store::Mode::write_shared) {
    sqlite_.exec("PRAGMA journal_mode = DELETE");
  } else {
    sqlite_.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  }
}

StoreFile::~StoreFile() {
  if (mode_ == Store::Mode::write) fold();
  if (mode_ != Store::Mode::write_shared) return;
  try {
    number("SELECT count(*) FROM sqlite_master");  // SQLite undoes a failed write only now
  } catch (const SQLite::Exception&) {             // the next writer undoes it
  }
}

// False if the file was unlinked or moved away; SQLite would go on writing it.
bool StoreFile::is_in_place() const { return identity_ && identity_of(sqlite_.getFilename()) == identity_; }

void StoreFile::check_place() const {
  if (!is_in_place()) refuse_taken_away(name_);
}

void StoreFile::commit(SQLite::Transaction& transaction) {
  transaction.commit();
  check_place();
}

// Folds the log in; false if another process reads or writes. The committed data are safe even then, and the next
// writer folds it in.
bool StoreFile::fold() {
  try {
    sqlite_.setBusyTimeout(0);
    sqlite_.exec("PRAGMA wal_checkpoint(TRUNCATE)");
    if (is_in_place()) sqlite_.exec("PRAGMA journal_mode = DELETE");  // else it would remove another file's log
    return true;
  } catch (const SQLite::Exception&) {
    return false;
  }
}

void StoreFile::fold_with_patience() {
  const auto deadline = std::chrono::steady_clock::now() + folding_patience;
  while (!fold() && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  sqlite_.setBusyTimeout(busy_timeout_ms);
}

std::vector<std::filesystem::path> StoreFile::finish() {
  if (mode_ == Store::Mode::write) fold_with_patience();
  check_place();
  const std::filesystem::path place =
      std::filesystem::is_symlink(name_) ? std::filesystem::canonical(name_) : std::filesystem::path(name_);
  const std::filesystem::path log = place.string() + "-wal";
  std::error_code no_log;
  const auto size = std::filesystem::file_size(log, no_log);
  if (no_log || size == 0) return {place};
  return {place, log};
}

// The file is not trusted: none of its SQL is run (https://www.sqlite.org/security.html).
void StoreFile::distrust() {
  sqlite3* const handle = sqlite_.getHandle();
  for (const auto& [option, value] :
       {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1}, std::pair{SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
        std::pair{SQLITE_DBCONFIG_ENABLE_TRIGGER, 0}, std::pair{SQLITE_DBCONFIG_ENABLE_VIEW, 0}})
    sqlite3_db_config(handle, option, value, static_cast<int*>(nullptr));
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, largest_value);
  sqlite_.exec("PRAGMA cell_size_check = ON");
}

void StoreFile::check_header() {
  if (std::filesystem::file_size(name_) == 0 && number("PRAGMA page_count") == 0)
    throw HalfWritten(fmt::format(
        "'{}' is not an ikbench store yet: it is empty, because ikbench was killed when it began; give the command "
        "that was killed again, which goes on with it",
        name_));
  if (number("PRAGMA application_id") != application_id)
    throw std::invalid_argument(fmt::format(
        "'{}' is not an ikbench store: another program wrote it; expected a file written by ikbench", name_));
  if (const std::int64_t version = number("PRAGMA user_version"); version != store_version) {
    SQLite::Statement maker(sqlite_, "SELECT value FROM environment WHERE key = 'version' ORDER BY session DESC");
    throw std::invalid_argument(fmt::format(
        "'{}' is a store of version {}{}, and this ikbench reads version {} alone; ikbench 1.0 reads it, or "
        "run its studies into a new store",
        name_, version, maker.executeStep() ? ", made by ikbench " + maker.getColumn(0).getString() : "",
        store_version));
  }
}

// The tables are ours to the letter, so nothing in them calculates, and their keys hold.
void StoreFile::check_tables() {
  const auto tables_of = [](SQLite::Database& sqlite) {
    std::vector<std::string> tables;
    SQLite::Statement query(sqlite,
                            "SELECT type || ' ' || name || ' ' || coalesce(sql, '') FROM sqlite_master ORDER BY 1");
    while (query.executeStep()) tables.push_back(query.getColumn(0).getString());
    return tables;
  };
  SQLite::Database ours(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  ours.exec(create_tables());
  if (tables_of(sqlite_) != tables_of(ours)) throw Damage("its tables are not those that ikbench makes");
  if (number("SELECT count(*) FROM studies WHERE length(name) > 1000 OR length(definition) > 1000000") > 0)
    throw Damage("a study has a name of more than 1000 letters, or a definition of more than 1 MB");
  if (number("SELECT count(*) FROM series WHERE length(label) > 1000 OR length(options) > 1000000") > 0 ||
      number("SELECT count(*) FROM (SELECT 1 FROM series GROUP BY study HAVING count(*) > 1000)") > 0)
    throw Damage("a study has more than 1000 solvers, or one with a label or options that no study may have");
}

void StoreFile::check_pages() {
  // SQLite takes missing bytes of the last page for zeros.
  if (std::filesystem::file_size(name_) % static_cast<std::uintmax_t>(number("PRAGMA page_size")) != 0)
    throw Damage("it is truncated");
  const std::string found = sqlite_.execAndGet("PRAGMA quick_check(1)").getString();
  if (found != "ok") throw Damage(found.substr(found.rfind('\n') + 1));
}

}  // namespace ikbench::results
