// The file of a store: checks that it is ours; its permissions, place, locks and write-ahead log.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results/store.hpp"
#include "results/store_codec.hpp"

namespace ikbench::results {

// Throws `error` as a sentence about the file (store.hpp says which exception).
[[noreturn]] void refuse(const std::string& file, const SQLite::Exception& error);
[[noreturn]] void refuse(const std::string& file, const Damage& damage);

// Calls `action` and returns its result; refuses the file if SQLite fails or finds damage.
template <class Action>
auto guarded(const std::string& file, Action&& action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    refuse(file, error);
  } catch (const Damage& damage) {
    refuse(file, damage);
  }
}

// While it is written, a write-ahead log stands beside it (https://www.sqlite.org/wal.html): a killed process loses
// nothing that was committed, and one transaction per solve costs no wait for the disk. The last writer folds the log
// in, so a finished store is one plain file.
// All users of a log must be on one machine. A store in a folder of several machines (Store::Mode::write_shared) has a
// rollback journal instead, during a transaction only.
class StoreFile {
 public:
  // Opens the file and checks that it is a store. For writing, creates a missing one. Throws Damage, SQLite::Exception,
  // or as store.hpp says.
  StoreFile(const std::filesystem::path& path, Store::Mode mode);
  ~StoreFile();
  StoreFile(const StoreFile&) = delete;
  StoreFile& operator=(const StoreFile&) = delete;

  const std::string& name() const { return name_; }  // as the user gave it
  SQLite::Database& sqlite() { return sqlite_; }
  std::int64_t number(const char* query) { return sqlite_.execAndGet(query).getInt64(); }

  // Throws std::runtime_error if the file is no longer in its place.
  void commit(SQLite::Transaction& transaction);
  // See Store::finish.
  std::vector<std::filesystem::path> finish();

  using Identity = std::pair<dev_t, ino_t>;  // a path's file, by device and number
  static std::optional<Identity> identity_of(const std::string& path);

 private:
  void distrust();
  void check_header();
  void check_tables();
  void check_pages();
  bool is_in_place() const;
  void check_place() const;
  bool fold();
  void fold_with_patience();

  std::string name_;
  Store::Mode mode_;
  SQLite::Database sqlite_;
  std::optional<Identity> identity_;  // of the opened file
};

}  // namespace ikbench::results
