// The file of a store: whether it is one, and ours; its permissions, its place, its locks and its write-ahead log.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results/store.hpp"
#include "results/store_codec.hpp"
#include "results/writer_mark.hpp"

namespace ikbench::results {

// Throws what `error` says of the file, as a sentence (store.hpp: which exception).
[[noreturn]] void refuse(const std::string& file, const SQLite::Exception& error);
[[noreturn]] void refuse(const std::string& file, const Damage& damage);

// What `action` returns; where SQLite fails or there is damage, the sentence about the file.
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

// While it is written it has a write-ahead log beside it (https://www.sqlite.org/wal.html): a process that is killed
// loses nothing that was committed, and one transaction per solve costs no wait for the disk. The last writer to finish
// folds the log in: a finished store is one plain file.
// All who use a log must be on one machine. A store that is written in a folder of several machines
// (Store::Mode::write_shared) has a rollback journal instead, during a transaction only, and a mark of its writer.
class StoreFile {
 public:
  // Opens the file and checks that it is a store. To write, it is made where it is missing. Damage, SQLite::Exception,
  // or what store.hpp says.
  StoreFile(const std::filesystem::path& path, Store::Mode mode);
  ~StoreFile();
  StoreFile(const StoreFile&) = delete;
  StoreFile& operator=(const StoreFile&) = delete;

  const std::string& name() const { return name_; }  // as the user gave it
  SQLite::Database& sqlite() { return sqlite_; }
  std::int64_t number(const char* query) { return sqlite_.execAndGet(query).getInt64(); }

  // Blobs equal no text, so that a search would pass over them; they come after every text.
  void refuse_blobs(const char* table, const char* column);
  // std::runtime_error where the file is no longer in its place. It has so many new solves.
  void commit(SQLite::Transaction& transaction, std::int64_t solves = 0);
  // Store::finish.
  std::vector<std::filesystem::path> finish();

  using Identity = std::pair<dev_t, ino_t>;  // which file a path leads to: its device and number there
  static std::optional<Identity> identity_of(const std::string& path);

 private:
  void distrust();
  void check_header();
  void check_tables();
  bool is_in_place() const;
  void check_place() const;
  bool fold();
  void fold_with_patience();

  std::string name_;
  Store::Mode mode_;
  SQLite::Database sqlite_;
  std::optional<WriterMark> mark_;
  std::optional<Identity> identity_;  // of the file that was opened
};

}  // namespace ikbench::results
