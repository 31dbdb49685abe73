// What a store does when the world is against it: wrong files, damage, kill -9, rivals, no permission to write.
#include <SQLiteCpp/SQLiteCpp.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <random>

#include "results/store.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;

namespace {

// What Store says when it refuses the file; the sentence names the file, always.
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

void read_everything(const std::filesystem::path& file) {
  const Store store(file, Store::Mode::read);
  store.studies();
  store.sessions();
  store.solves("table-3");
}

// Runs `action` in a process of its own; the process's exit code is 0 if it returned true.
pid_t in_a_process(const std::function<bool()>& action) {
  const pid_t child = fork();
  if (child != 0) return child;
  try {
    _exit(action() ? 0 : 1);
  } catch (const std::exception& error) {
    fprintf(stderr, "%s\n", error.what());
    _exit(2);
  }
}

int exit_code(pid_t child) {
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("what is not a store is refused in a sentence", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  for (const auto mode : {Store::Mode::read, Store::Mode::write}) {
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
  CHECK_THAT(refusal(file / "below" / "a.ikb", Store::Mode::write), ContainsSubstring("cannot be made"));
}

TEST_CASE("another program's database is refused and left as it is", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "other.db";
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE t (a)");
  const std::string before = text_in(file);
  for (const auto mode : {Store::Mode::read, Store::Mode::write})
    CHECK_THAT(refusal(file, mode), ContainsSubstring("is not an ikbench store: another program wrote it"));
  CHECK(text_in(file) == before);
}

TEST_CASE("an empty file is no store to a reader and a new store to a writer", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_text(file, "");
  CHECK_THAT(refusal(file), ContainsSubstring("is not an ikbench store"));
  write_store(file);
  CHECK(Store(file, Store::Mode::read).solves("table-3").size() == 40);
}

TEST_CASE("a newer schema is refused with both versions", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_store(file);
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 7");
  for (const auto mode : {Store::Mode::read, Store::Mode::write})
    CHECK_THAT(refusal(file, mode), ContainsSubstring("has schema 7, newer than the 1"));
}

TEST_CASE("a store cut short anywhere is refused", "[store][faults]") {
  const ScratchFolder folder;
  write_store(folder.path / "whole.ikb");
  const std::string whole = text_in(folder.path / "whole.ikb");
  const auto file = folder.path / "a.ikb";
  std::vector<std::size_t> lengths;
  for (std::size_t length = 1; length < whole.size(); length += length < 1024 ? 37 : 1021) lengths.push_back(length);
  for (std::size_t page = 4096; page < whole.size(); page += 4096) lengths.push_back(page);
  for (const std::size_t length : lengths) {
    CAPTURE(length, whole.size());
    write_text(file, whole.substr(0, length));
    CHECK_THAT(refusal(file), ContainsSubstring("is damaged") || ContainsSubstring("is not an ikbench store"));
  }
}

TEST_CASE("a store with bytes overwritten is read or refused, nothing else", "[store][faults][property]") {
  const ScratchFolder folder;
  write_store(folder.path / "whole.ikb");
  const std::string whole = text_in(folder.path / "whole.ikb");
  const auto file = folder.path / "a.ikb";
  std::mt19937 random(18);
  int refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
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

TEST_CASE("values that no store of ours has are damage", "[store][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  for (const auto& [change, word] : std::vector<std::pair<std::string, std::string>>{
           {"UPDATE solves SET status = 'fine'", "status 'fine'"},
           {"UPDATE solves SET answer_rad = '1,2'", "'1,2' is not a list"},
           {"UPDATE solves SET answer_rad = '[1,,2]'", "'' in a list"},
           {"UPDATE solves SET answer_rad = '[1,x]'", "'x' in a list"},
           {"UPDATE solves SET run = -9999999999 WHERE run = 1", "run -9999999999"},
           {"UPDATE studies SET definition = '{'", "the definition of study 'table-3'"},
           {"DROP TABLE series", "no such table: series"},
           {"ALTER TABLE solves DROP COLUMN seconds", "no such column: seconds"}}) {
    CAPTURE(change);
    std::filesystem::remove(file);
    write_store(file);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(change);
    const std::string said = complaint<std::invalid_argument>([&] { read_everything(file); });
    CHECK_THAT(said, ContainsSubstring(quoted(file) + " is damaged"));
    CHECK_THAT(said, ContainsSubstring(word));
  }
}

TEST_CASE("kill -9 loses nothing that was committed", "[store][faults]") {
  std::mt19937 random(9);
  for (int trial = 0; trial < 8; ++trial) {
    const ScratchFolder folder;
    const auto file = folder.path / "a.ikb";
    int acknowledged[2];
    REQUIRE(pipe(acknowledged) == 0);
    const pid_t writer = in_a_process([&] {
      Store store(file, Store::Mode::write);
      store.save_study(sample_study());
      SolveRecord record = sample_record("key-a");
      record.trace_cm.assign(500, 0.1234567890123);  // so that the log is folded in now and then
      for (record.run = 1;; ++record.run) {
        store.append({record});
        if (write(acknowledged[1], "!", 1) != 1) return false;
      }
    });
    close(acknowledged[1]);
    int solves = 0;
    char byte = 0;
    for (auto enough = 1 + random() % 1000; enough > 0 && read(acknowledged[0], &byte, 1) == 1; --enough) ++solves;
    REQUIRE(kill(writer, SIGKILL) == 0);
    while (read(acknowledged[0], &byte, 1) == 1) ++solves;
    close(acknowledged[0]);
    CHECK(exit_code(writer) == -1);

    CAPTURE(trial, solves);
    const auto check_solves = [&] {
      const auto records = Store(file, Store::Mode::read).series("key-a");
      const int kept = static_cast<int>(records.size());
      CHECK(kept >= solves);
      CHECK(kept <= solves + 1);  // the last may have been committed and not yet acknowledged
      for (int i = 0; i < kept; ++i) CHECK(records[static_cast<std::size_t>(i)].run == i + 1);
    };
    check_solves();
    Store(file, Store::Mode::write).append({sample_record("key-b")});  // goes on, and closes properly
    CHECK(!std::filesystem::exists(file.string() + "-wal"));
    check_solves();
  }
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
    CHECK(store.series("key-c").size() == 1);
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
  const pid_t first = write_series("key-a");
  const pid_t second = write_series("key-b");
  CHECK(exit_code(first) == 0);
  CHECK(exit_code(second) == 0);
  const Store store(file, Store::Mode::read);
  CHECK(store.series("key-a").size() == 200);
  CHECK(store.series("key-b").size() == 200);
  CHECK(store.sessions().size() == 40);
}

TEST_CASE("a store that another process keeps locked is refused after a wait", "[store][faults][.slow]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_store(file);
  SQLite::Database rival(file.string(), SQLite::OPEN_READWRITE);
  rival.exec("BEGIN IMMEDIATE");
  CHECK_THAT(complaint<std::runtime_error>([&] { const Store store(file, Store::Mode::write); }),
             ContainsSubstring("was kept locked by another process for 10 s"));
}

TEST_CASE("a reader needs no permission to write, neither to the store nor to its folder", "[store][faults]") {
  using std::filesystem::perms;
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_store(file);
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
    if (geteuid() == 0 && setuid(65534) != 0) return false;  // root may write anything; nobody may not
    if (Store(file, Store::Mode::read).solves("table-3").size() != 40) return false;
    if (refusal(file, Store::Mode::write).empty()) return false;
    return refusal(unfinished).find("copy the store with its '-wal' file") != std::string::npos;
  });
  CHECK(exit_code(reader) == 0);
  std::filesystem::permissions(folder.path, perms::owner_all);
}
