// A store in adversity: wrong files, damage, kill -9, rivals, no permission to write.
#include <fcntl.h>
#include <sys/syscall.h>

#include <cstdarg>

#include "tests/results/samples.hpp"

#ifdef __GLIBC__
// In front of the C library's, for SQLite too: locks as network file systems without a lock daemon answer them.
bool has_locks = true;
extern "C" int fcntl64(int descriptor, int command, ...) {
  va_list rest;
  va_start(rest, command);
  void* const argument = va_arg(rest, void*);
  va_end(rest);
  if (has_locks || (command != F_SETLK && command != F_GETLK))
    return static_cast<int>(syscall(SYS_fcntl, descriptor, command, argument));
  errno = ENOLCK;
  return -1;
}
extern "C" int fcntl(int, int, ...) __attribute__((alias("fcntl64")));
#endif

namespace {

// The message with which Store refuses the file; it always names the file.
std::string refusal(const std::filesystem::path& file, Store::Mode mode = Store::Mode::read) {
  const std::string said = complaint<std::invalid_argument>([&] { const Store store(file, mode); });
  CHECK_THAT(said, ContainsSubstring(quoted(file)));
  return said;
}

// A closed store with a study, a session and forty solves.
void write_store(const std::filesystem::path& file) {
  Store store(file, Store::Mode::write);
  store.save_study(sample_study());
  store.begin_session({{"cpu", "x"}});
  for (int run = 1; run <= 20; ++run) store.append({sample_record("key-a", run), sample_record("key-b", run)});
}

// A folder with a store.
struct StoreFile {
  StoreFile() { write_store(file); }
  ScratchFolder folder;
  const std::filesystem::path file = folder.path / "a.ikb";
};

void read_everything(const std::filesystem::path& file) {
  const Store store(file, Store::Mode::read);
  store.studies();
  store.sessions();
  solves_of(store, "table-3");
}

}  // namespace

TEST_CASE("what is not a store is refused in a sentence", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  const auto other = folder.path / "other.db";
  SQLite::Database(other.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE t (a)");
  const std::string before = text_in(other);
  for (const auto mode : {Store::Mode::read, Store::Mode::write}) {
    CHECK_THAT(refusal(other, mode), ContainsSubstring("is not an ikbench store: another program wrote it"));
    CHECK(text_in(other) == before);
    CHECK_THAT(refusal(folder.path, mode), ContainsSubstring("is a folder"));
    CHECK_THAT(refusal("", mode), ContainsSubstring("is a folder"));
    CHECK_THAT(refusal("/dev/null", mode), ContainsSubstring("is not a regular file"));
    for (const std::string& text : {std::string("xy"), std::string("run,point\n1,1\n"), std::string(100'000, 'x')}) {
      write_text(file, text);
      CHECK_THAT(refusal(file, mode), ContainsSubstring("is not an ikbench store"));
      CHECK(text_in(file) == text);
    }
  }
  CHECK_THAT(refusal(folder.path / "none.ikb"), ContainsSubstring("does not exist"));
  CHECK(!std::filesystem::exists(folder.path / "none.ikb"));
  CHECK_THAT(refusal(file / "below" / "a.ikb", Store::Mode::write), ContainsSubstring("cannot write"));
}

TEST_CASE("an empty file is no store to a reader and a new store to a writer", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_text(file, "");
  CHECK_THAT(refusal(file), ContainsSubstring("is not an ikbench store"));
  write_store(file);
  CHECK(solves_of(Store(file, Store::Mode::read), "table-3").size() == 40);
}

TEST_CASE_METHOD(StoreFile, "a store of another version is refused and stays as it is", "[store][faults]") {
  for (const int version : {-1, 0, 1, 2, 3, 700}) {
    CAPTURE(version);
    edit(file, fmt::format("PRAGMA user_version = {}", version));
    const std::string before = text_in(file);
    for (const auto mode : {Store::Mode::read, Store::Mode::write, Store::Mode::write_shared})
      CHECK_THAT(refusal(file, mode),
                 ContainsSubstring(fmt::format("{} is a store of version {}, but this ikbench reads only version 4",
                                               quoted(file), version)));
    CHECK(text_in(file) == before);
  }
}

TEST_CASE("damage is not taken for the failed read of another file", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb", log = folder.path / "a.ikb-wal";
  Store writer(file, Store::Mode::write);
  writer.save_study(sample_study());
  const Store store(file, Store::Mode::read);
  writer.save_study(sample_study());  // so that its pages are read again
  std::string damaged = text_in(log);
  for (std::size_t page = 32 + 24; page < damaged.size(); page += 16384 + 24)
    if (damaged[page] != 'S') damaged[page] = 'x';  // the kind of each but the first
  std::ofstream(log, std::ios::in | std::ios::binary) << damaged;
  errno = EIO;
  CHECK_THAT(complaint<std::invalid_argument>([&] { store.studies(); }), ContainsSubstring("is damaged"));
}

TEST_CASE_METHOD(StoreFile, "a store cut short anywhere is refused", "[store][faults]") {
  const std::string whole = text_in(file);
  std::vector<std::size_t> lengths;
  for (std::size_t length = 1; length < whole.size(); length += length < 1024 ? 37 : 1021) lengths.push_back(length);
  for (std::size_t page = 4096; page < whole.size(); page += 4096) lengths.push_back(page);
  for (const std::size_t length : lengths) {
    CAPTURE(length, whole.size());
    write_text(file, whole.substr(0, length));
    CHECK_THAT(refusal(file), ContainsSubstring("is damaged") || ContainsSubstring("is not an ikbench store"));
  }
}

TEST_CASE_METHOD(StoreFile, "a store with bytes overwritten is read or refused, nothing else",
                 "[store][faults][property]") {
  const std::string whole = text_in(file);
  std::mt19937 random(18);
  int refused = 0;
  for (int trial = 0; trial < 600; ++trial) {
    std::string bytes = whole;
    const std::size_t begin = random() % bytes.size();
    const std::size_t length = trial % 2 == 0 ? 1 : 2000;
    for (std::size_t i = begin; i < std::min(begin + length, bytes.size()); ++i) bytes[i] = static_cast<char>(random());
    write_text(file, bytes);
    CAPTURE(trial, begin, length);
    const std::string said = complaint<std::invalid_argument>([&] { read_everything(file); });
    if (!said.empty()) {
      ++refused;
      CHECK_THAT(said, ContainsSubstring("a.ikb"));
    }
  }
  CHECK(refused > 50);
}

TEST_CASE_METHOD(StoreFile, "a value that ikbench does not write is damage, and SQLite takes none of another type",
                 "[store][faults]") {
  for (const auto& [change, word] : std::vector<std::pair<std::string, std::string>>{
           {"status = 'fine'", "status: 'fine'"},
           {"answer_rad = '1,2'", "answer_rad: '1,2' is not a list"},
           {"answer_rad = '[1,,2]'", "'' in a list"},
           {"status = 'fine' || char(0) || 'x'", "status: 'fine x'; in the solve"},
           {"answer_rad = '[1,]'", "an empty place in a list"},
           {"answer_rad = '[1x2]'", "'1x2' in a list"},
           {"answer_rad = '[1,x]' WHERE run = 2",
            "(answer_rad: 'x' in a list of numbers; in the solve of run 2, point 1 of series 'key-a')"},
           {"position_error_cm = -1", "position_error_cm is -1, which no solve has"},
           {"seconds = 0", "seconds is 0, which no solve has"},
           {"label = 'other'", "the label of 'IK-BA' differs in its solves"},
           {"batch_size = 5000000000", "batch_size: 5000000000"}}) {
    CAPTURE(change);
    const StoreFile other;
    edit(other.file, "UPDATE solves SET " + change);
    const std::string said = complaint<std::invalid_argument>([&] { read_everything(other.file); });
    CHECK_THAT(said, ContainsSubstring(quoted(other.file) + " is damaged") && ContainsSubstring(word));
  }
  SQLite::Database sqlite(file.string(), SQLite::OPEN_READWRITE);
  for (const char* change : {"position_error_cm = 'abc'", "seconds = x'00'", "iterations = 2.5", "run = 'two'"})
    CHECK_THROWS_AS(sqlite.exec(fmt::format("UPDATE solves SET {}", change)), SQLite::Exception);
}

TEST_CASE("a store with other tables, views, indexes or triggers than ours is refused", "[store][faults]") {
  for (
      const char* change :
      {"ALTER TABLE environment RENAME TO e; CREATE VIEW environment AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL "
       "SELECT x + 1 FROM c) SELECT 1 AS session, 'k' || x AS key, 'v' AS value FROM c",
       "DELETE FROM solves; ALTER TABLE solves ADD COLUMN big TEXT AS (hex(zeroblob(1000000000)))",
       "DROP VIEW run_means", "CREATE TABLE mine (a)", "CREATE INDEX mine ON solves (seconds)",
       "CREATE TRIGGER mine AFTER INSERT ON solves BEGIN DELETE FROM solves; END",
       "PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = replace(sql, 'STRICT', '') WHERE name = 'solves'"}) {
    CAPTURE(change);
    const StoreFile store;
    edit(store.file, change);
    for (const auto mode : {Store::Mode::read, Store::Mode::write})
      CHECK_THAT(refusal(store.file, mode), ContainsSubstring("its tables and views are not those that ikbench makes"));
  }
}

TEST_CASE("what the system makes while it is read is no store, and is not waited for", "[store][faults]") {
#ifdef __linux__
  for (const auto mode : {Store::Mode::read, Store::Mode::write, Store::Mode::write_shared}) {
    CHECK_THAT(refusal("/proc/self/status", mode), ContainsSubstring("is not a regular file"));
    CHECK_FALSE(refusal("/proc/kmsg", mode).empty());  // which some may not open
  }
#endif
}

TEST_CASE("studies that no study file makes are damage", "[store][faults]") {
  const std::pair<const char*, const char*> changes[]{
      {"UPDATE studies SET definition = '5'", "is not a JSON object"},
      {"UPDATE series SET options = '{broken'", "is not a JSON object"},
      {"INSERT INTO series WITH RECURSIVE c(x) AS (SELECT 9 UNION ALL SELECT x + 1 FROM c WHERE x < 1009) "
       "SELECT name, x, 'k' || x, 'l' || x, 'a', '{}' FROM c, studies",
       "has more than 400 solvers"}};
  for (const auto& [change, word] : changes) {
    const StoreFile store;
    edit(store.file, change);
    CHECK_THAT(complaint<std::invalid_argument>([&] { Store(store.file, Store::Mode::read).studies(); }),
               ContainsSubstring("is damaged (") && ContainsSubstring(word));
  }
}

TEST_CASE("half a page, which a kill leaves while the log is folded in, is no damage", "[store][faults]") {
  const ScratchFolder folder;
  const std::string file = folder.path / "a.ikb", killed = folder.path / "killed.ikb";
  Store store(file, Store::Mode::write);
  store.save_study(sample_study());
  SolveRecord record = sample_record("key-a");
  record.trace_cm.assign(500, 0.1234567890123);
  for (record.run = 1; record.run <= 20; ++record.run) store.append({record});
  for (const char* part : {"", "-wal"}) std::filesystem::copy_file(file + part, killed + part);
  std::filesystem::resize_file(killed, std::filesystem::file_size(killed) + 4096);
  for (const auto mode : {Store::Mode::read, Store::Mode::write})
    CHECK(series_of(Store(killed, mode), "key-a").size() == 20);
  std::filesystem::resize_file(killed, std::filesystem::file_size(killed) - 6);
  write_text(killed + "-wal", "x");  // a log without that page
  CHECK(contains(complaint<std::invalid_argument>([&] { Store(killed, Store::Mode::read); }), "it is truncated"));
}

TEST_CASE("kill -9 while a store is made leaves a file that becomes a store", "[store][faults]") {
  for (int delay_us = 0; delay_us < 6000; delay_us += 300) {
    const ScratchFolder folder;
    const auto file = folder.path / "a.ikb";
    const pid_t writer = in_a_process([&]() -> bool {
      for (;;) {
        std::filesystem::remove(file);
        write_store(file);
      }
    });
    usleep(static_cast<useconds_t>(delay_us));
    kill(writer, SIGKILL);
    CHECK(exit_code(writer) == -1);
    CAPTURE(delay_us);
    Store store(file, Store::Mode::write);
    store.append({sample_record("key-c")});
    CHECK(series_of(store, "key-c").size() == 1);
  }
}

TEST_CASE("two processes can write one store, opening and closing it as they like", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  const auto write_series = [&](const std::string& key) {
    return in_a_process([&file, key] {
      for (int run = 1; run <= 20; ++run) {
        Store store(file, Store::Mode::write);
        for (int point = 1; point <= 10; ++point) store.append({sample_record(key, run, point)});
        store.begin_session({});
      }
      return true;
    });
  };
  const pid_t first = write_series("key-a"), second = write_series("key-b");
  CHECK(exit_code(first) == 0);
  CHECK(exit_code(second) == 0);
  const Store store(file, Store::Mode::read);
  CHECK(series_of(store, "key-a").size() == 200);
  CHECK(series_of(store, "key-b").size() == 200);
  CHECK(store.sessions().size() == 40);
}

TEST_CASE("a store that is removed, moved or replaced while it is written is a failure, not a success",
          "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "out" / "a.ikb", other = folder.path / "other.ikb";
  write_store(other);
  const std::vector<std::function<void()>> ways{
      [&] { std::filesystem::remove_all(file.parent_path()); },
      [&] { std::filesystem::remove(file); },
      [&] { std::filesystem::rename(file.parent_path(), folder.path / "moved"); },
      [&] {
        std::filesystem::copy_file(other, folder.path / "copy.ikb");
        std::filesystem::rename(folder.path / "copy.ikb", file);
      },
  };
  for (std::size_t way = 0; way < ways.size(); ++way) {
    CAPTURE(way);
    const std::string words = quoted(file) + " was removed, moved or replaced while ikbench wrote to it";
    for (const bool in_the_middle : {true, false}) {
      Store store(file, Store::Mode::write);
      store.save_study(sample_study());
      store.append({sample_record("key-a", 1, 1)});
      ways[way]();
      if (in_the_middle) {
        CHECK_THAT(complaint<std::runtime_error>([&] { store.append({sample_record("key-a", 1, 2)}); }),
                   ContainsSubstring(words));
        CHECK_THAT(complaint<std::runtime_error>([&] { store.save_study(sample_study()); }), ContainsSubstring(words));
        CHECK_THAT(complaint<std::runtime_error>([&] { store.begin_session({}); }), ContainsSubstring(words));
      }
      CHECK_THAT(complaint<std::runtime_error>([&] { store.close(); }), ContainsSubstring(words));
      std::filesystem::remove_all(file.parent_path());
      std::filesystem::remove_all(folder.path / "moved");
    }
  }
}

TEST_CASE("a store that takes the place of one that is written loses nothing", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  {
    Store first(file, Store::Mode::write);
    first.append({sample_record()});
    std::filesystem::remove(file);
    std::filesystem::remove(file.string() + "-wal");
    std::filesystem::remove(file.string() + "-shm");
    const pid_t second = in_a_process([&] {
      Store store(file, Store::Mode::write);
      for (int run = 1; run <= 3; ++run) store.append({sample_record("key-b", run)});
      return kill(getpid(), SIGKILL) == 0;  // its solves are in its log
    });
    CHECK(exit_code(second) == -1);
    REQUIRE(std::filesystem::file_size(file.string() + "-wal") > 0);
  }
  CHECK(series_of(Store(file, Store::Mode::read), "key-b").size() == 3);
}

TEST_CASE_METHOD(StoreFile, "the end of writing waits for a reader, and leaves one file that can be copied alone",
                 "[store][faults]") {
  Store store(file, Store::Mode::write);
  store.append({sample_record("key-a", 21)});
  std::promise<void> reads;
  const auto reader = std::async(std::launch::async, [&] {
    SQLite::Database sqlite(file.string(), SQLite::OPEN_READONLY);
    SQLite::Statement query(sqlite, "SELECT * FROM solves");
    query.executeStep();
    reads.set_value();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  });
  reads.get_future().wait();
  store.append({sample_record("key-b", 21)});
  CHECK(store.close() == std::vector{file});
  CHECK(!std::filesystem::exists(file.string() + "-wal"));
  std::filesystem::copy_file(file, folder.path / "copy.ikb");
  CHECK(series_of(Store(folder.path / "copy.ikb", Store::Mode::read), "key-b").size() == 21);
}

TEST_CASE_METHOD(StoreFile,
                 "where a reader does not end, the files that belong together are named, and together they are whole",
                 "[store][faults]") {
  const auto log = folder.path / "a.ikb-wal";
  {
    SQLite::Database reader(file.string(), SQLite::OPEN_READONLY);
    Store store(file, Store::Mode::write);
    store.append({sample_record("key-a", 21)});
    SQLite::Statement query(reader, "SELECT * FROM solves");
    query.executeStep();
    store.append({sample_record("key-b", 21)});
    CHECK(store.close() == std::vector{file, log});
    std::filesystem::copy_file(file, folder.path / "copy.ikb");
    std::filesystem::copy_file(log, folder.path / "copy.ikb-wal");
  }
  const auto solves = [](const std::filesystem::path& of) {
    const Store store(of, Store::Mode::read);
    return series_of(store, "key-a").size() + series_of(store, "key-b").size();
  };
  CHECK(solves(folder.path / "copy.ikb") == 42);
  CHECK(Store(file, Store::Mode::write).close() == std::vector{file});  // running again makes one file of them
  CHECK(solves(file) == 42);
}

TEST_CASE_METHOD(StoreFile, "a store that a kill left half-written is told apart, and writing mends it",
                 "[store][faults]") {
  leave_half_written(file);
  CHECK_THAT(refusal(file), ContainsSubstring("is half-written, because ikbench was killed") &&
                                ContainsSubstring(quoted(std::filesystem::path(file.string() + "-journal"))) &&
                                ContainsSubstring("repeat the command that wrote it"));
  CHECK(Store(file, Store::Mode::write).close() == std::vector{file});
  const std::vector<SolveRecord> solves = solves_of(Store(file, Store::Mode::read), "table-3");
  REQUIRE(solves.size() == 40);
  CHECK(same(solves.front(), sample_record()));
}

TEST_CASE_METHOD(StoreFile, "a reader needs no permission to write, neither to the store nor to its folder",
                 "[store][faults]") {
  using std::filesystem::perms;
  // A run that was killed: its log is still beside the store.
  const auto unfinished = folder.path / "unfinished.ikb";
  exit_code(in_a_process([&] {
    Store store(unfinished, Store::Mode::write);
    store.append({sample_record()});
    std::filesystem::remove(unfinished.string() + "-shm");
    return kill(getpid(), SIGKILL) == 0;
  }));
  REQUIRE(std::filesystem::exists(unfinished.string() + "-wal"));
  std::filesystem::permissions(file, perms{0444});
  std::filesystem::permissions(unfinished, perms{0444});
  std::filesystem::permissions(folder.path, perms{0555});

  const pid_t reader = in_a_process([&] {
    if (geteuid() == 0 && setuid(65534) != 0) return false;  // root may write anything; the user nobody may not
    if (solves_of(Store(file, Store::Mode::read), "table-3").size() != 40) return false;
    if (refusal(file, Store::Mode::write).empty()) return false;
    return refusal(unfinished).find("copy the store with its '-wal' file") != std::string::npos;
  });
  CHECK(exit_code(reader) == 0);
  std::filesystem::permissions(folder.path, perms::owner_all);
}

#ifdef __GLIBC__
TEST_CASE_METHOD(StoreFile, "a folder without locks is told as such", "[store][faults]") {
  has_locks = false;
  const std::string said = refusal(file, Store::Mode::write);
  has_locks = true;
  CHECK_THAT(said, ContainsSubstring("this folder's file system has no locks"));
  read_everything(file);
}
#endif
