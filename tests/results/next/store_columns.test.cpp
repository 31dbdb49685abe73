// What a program with five columns more (tests/examples/results/columns.inc) makes of the older stores: it reads them,
// gives them the columns when it writes, and loses nothing when it is killed in between.
#include <SQLiteCpp/SQLiteCpp.h>
#include <signal.h>
#include <unistd.h>

#include <random>

#include "results/csv.hpp"
#include "results/export.hpp"
#include "results/fingerprint.hpp"
#include "results/store.hpp"
#include "tests/catch.hpp"
#include "tests/results/processes.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;

namespace {

// Versions of the schema: of the project's columns, and of those with the five.
const int newest = static_cast<int>(columns().size()) - 25, today = newest - 5;
const std::vector<std::string> added{"start_error_cm", "repetitions", "timing_before", "remark", "all_seconds"};

void change(const std::filesystem::path& file, const std::string& sql) {
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(sql);
}

std::int64_t version_of(const std::filesystem::path& file) {
  return SQLite::Database(file.string()).execAndGet("PRAGMA user_version").getInt64();
}

// The file as a program of an older schema would have left it: without the last columns.
void make_older(const std::filesystem::path& file, int version) {
  std::string sql;
  for (int column = newest - 1; column >= version; --column)
    sql += fmt::format("ALTER TABLE solves DROP COLUMN {}; ", added[static_cast<std::size_t>(column - today)]);
  change(file,
         sql + fmt::format("PRAGMA user_version = {0}; UPDATE meta SET value = '{0}' WHERE key = 'schema'", version));
}

SolveRecord full_record(const std::string& series, int run) {
  SolveRecord record = sample_record(series, run);
  record.start_error_cm = 0.125;
  record.repetitions = 5;
  record.timing_before = Timing::parallel;
  record.remark = "'quoted'";
  record.all_seconds = {0.125, 0.25};
  return record;
}

// The record as it comes out of a store of an older schema.
SolveRecord as_of(SolveRecord record, int version) {
  const SolveRecord fresh;
  if (version == today) record.start_error_cm = std::numeric_limits<double>::quiet_NaN();
  if (version < today + 2) record.repetitions = fresh.repetitions;
  if (version < today + 3) record.timing_before = fresh.timing_before;
  if (version < today + 4) record.remark = fresh.remark;
  if (version < today + 5) record.all_seconds = fresh.all_seconds;
  return record;
}

// A study with `runs` runs of two solvers, in a store of an older schema.
void write_older(const std::filesystem::path& file, int version, int runs = 20) {
  {
    Store store(file, Store::Mode::write);
    store.save_study(sample_study());
    store.begin_session({{"cpu", "x"}});
    for (int run = 1; run <= runs; ++run) store.append({full_record("key-a", run), full_record("key-b", run)});
  }
  make_older(file, version);
}

void check_solves(const std::filesystem::path& file, int version) {
  const Store store(file, Store::Mode::read);
  CHECK(store.sessions().size() == 1);
  const std::vector<SolveRecord> solves = store.solves("table-3");
  REQUIRE(solves.size() == 40);
  for (int i = 0; i < 40; ++i) {
    const SolveRecord expected = as_of(full_record(i < 20 ? "key-a" : "key-b", i % 20 + 1), version);
    CHECK(same(solves[static_cast<std::size_t>(i)], expected));
  }
}

}  // namespace

TEST_CASE("a line of columns.inc is a column everywhere", "[store][columns]") {
  const std::vector<ColumnInfo> all = columns(), list(all.end() - 5, all.end());
  CHECK(list[0].name == "start_error_cm");
  CHECK(list[0].meaning == "distance to the target before the solve [cm]");
  CHECK(list[1].type == "integer");
  CHECK(list[2].type == "name");
  CHECK(list[4].type == "list of numbers");

  const CsvTable csv = parse_csv(to_csv({full_record("key-a", 1)}), "a.csv");
  CHECK(csv.rows[0][csv.column("start_error_cm")] == "0.125");
  CHECK(csv.rows[0][csv.column("repetitions")] == "5");
  CHECK(csv.rows[0][csv.column("timing_before")] == "parallel");
  CHECK(csv.rows[0][csv.column("remark")] == "'quoted'");
  CHECK(csv.rows[0][csv.column("all_seconds_2")] == "0.25");
  CHECK_THAT(to_json(sample_study(), {}, {full_record("key-a", 1)}),
             ContainsSubstring(R"("start_error_cm":0.125,"repetitions":5,"timing_before":"parallel",)"
                               R"("remark":"'quoted'","all_seconds":[0.125,0.25]})"));
}

TEST_CASE("a column that is added is not in the fingerprint", "[store][columns]") {
  CHECK(fingerprint({full_record("key-a", 1)}) == fingerprint({sample_record("key-a", 1)}));
}

TEST_CASE("a store that lacks columns is read, and writing gives it them", "[store][columns]") {
  for (int version = today; version <= newest; ++version) {
    CAPTURE(version);
    const ScratchFolder folder;
    const auto file = folder.path / "a.ikb";
    write_older(file, version);
    const std::string before = text_in(file);
    check_solves(file, version);
    CHECK(text_in(file) == before);  // a reader changes nothing

    Store(file, Store::Mode::write).append({full_record("key-a", 21)});
    CHECK(version_of(file) == newest);
    CHECK(SQLite::Database(file.string()).execAndGet("SELECT value FROM meta WHERE key = 'schema'").getString() ==
          std::to_string(newest));
    check_solves(file, version);
    CHECK(same(series_of(Store(file, Store::Mode::read), "key-a").back(), full_record("key-a", 21)));
  }
}

TEST_CASE("a store that was given columns has the schema of one that always had them", "[store][columns]") {
  const ScratchFolder folder;
  const auto old = folder.path / "old.ikb", fresh = folder.path / "fresh.ikb";
  write_older(old, today);
  for (const auto& file : {old, fresh}) const Store store(file, Store::Mode::write);
  const auto schema = [](const std::filesystem::path& file) {
    return SQLite::Database(file.string())
        .execAndGet("SELECT group_concat(sql, ';') FROM (SELECT sql FROM sqlite_master ORDER BY name)")
        .getString();
  };
  CHECK(schema(old) == schema(fresh));
  const SQLite::Database sqlite(old.string());
  CHECK(SQLite::Database(old.string()).execAndGet("PRAGMA integrity_check").getString() == "ok");
}

TEST_CASE("an older store that may not be written is read all the same", "[store][columns][faults]") {
  using std::filesystem::perms;
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_older(file, today);
  std::filesystem::permissions(file, perms{0444});
  std::filesystem::permissions(folder.path, perms{0555});
  const pid_t reader = in_a_process([&] {
    if (geteuid() == 0 && setuid(65534) != 0) return false;  // root may write anything; nobody may not
    if (Store(file, Store::Mode::read).solves("table-3").size() != 40) return false;
    return !complaint<std::invalid_argument>([&] { const Store store(file, Store::Mode::write); }).empty();
  });
  CHECK(exit_code(reader) == 0);
  std::filesystem::permissions(folder.path, perms::owner_all);
  CHECK(version_of(file) == today);
}

TEST_CASE("a store whose columns are not those of its version is damaged", "[store][columns][faults]") {
  for (const auto& [sql, word] : std::vector<std::pair<std::string, std::string>>{
           {"ALTER TABLE solves DROP COLUMN all_seconds", "its table solves has unexpected columns"},
           {"ALTER TABLE solves DROP COLUMN repetitions; PRAGMA user_version = " + std::to_string(newest - 1),
            "its table solves has unexpected columns"},
           {"ALTER TABLE solves DROP COLUMN seconds; PRAGMA user_version = " + std::to_string(newest - 1),
            "its table solves has unexpected columns"},
           {"PRAGMA user_version = " + std::to_string(newest - 1), "its table solves has unexpected columns"},
           {"ALTER TABLE solves ADD COLUMN more REAL", "its table solves has unexpected columns"},
           {"PRAGMA user_version = 0", "its user_version is 0"}}) {
    CAPTURE(sql);
    const ScratchFolder folder;
    const auto file = folder.path / "a.ikb";
    write_older(file, newest);
    change(file, sql);
    const std::string before = text_in(file);
    for (const auto mode : {Store::Mode::read, Store::Mode::write}) {
      const std::string said = complaint<std::invalid_argument>([&] { const Store store(file, mode); });
      CHECK_THAT(said, ContainsSubstring(quoted(file) + " is damaged") && ContainsSubstring(word));
    }
    CHECK(text_in(file) == before);
  }
}

TEST_CASE("an older store that is cut short or overwritten is refused or read, and not written",
          "[store][columns][faults]") {
  const ScratchFolder folder;
  write_older(folder.path / "whole.ikb", today);
  const std::string whole = text_in(folder.path / "whole.ikb");
  const auto file = folder.path / "a.ikb";
  for (std::size_t length = 4096; length < whole.size(); length += 4096) {
    write_text(file, whole.substr(0, length - 100));
    for (const auto mode : {Store::Mode::read, Store::Mode::write})
      CHECK_THAT(complaint<std::invalid_argument>([&] { const Store store(file, mode); }),
                 ContainsSubstring("is damaged") || ContainsSubstring("is not an ikbench store"));
    CHECK(text_in(file) == whole.substr(0, length - 100));
  }
}

TEST_CASE("a store of a newer program is refused with both versions, whatever columns it has", "[store][columns]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_older(file, newest);
  change(file, fmt::format("ALTER TABLE solves ADD COLUMN more REAL; PRAGMA user_version = {}", newest + 1));
  for (const auto mode : {Store::Mode::read, Store::Mode::write})
    CHECK_THAT(
        complaint<std::invalid_argument>([&] { const Store store(file, mode); }),
        ContainsSubstring(fmt::format("has schema {}, but this ikbench knows only up to {}", newest + 1, newest)));
}

TEST_CASE("a reader goes on reading a store that is given columns meanwhile, and sees what is in them",
          "[store][columns]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_older(file, today);
  const Store reader(file, Store::Mode::read);
  CHECK(series_of(reader, "key-a").size() == 20);
  Store(file, Store::Mode::write).append({full_record("key-a", 21)});
  const std::vector<SolveRecord> solves = series_of(reader, "key-a");
  REQUIRE(solves.size() == 21);
  CHECK(same(solves.front(), as_of(full_record("key-a", 1), today)));
  CHECK(same(solves.back(), full_record("key-a", 21)));
}

TEST_CASE("an older program that has the store open goes on writing, and its solves lack the new columns",
          "[store][columns]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_older(file, today);
  SQLite::Database older(file.string(), SQLite::OPEN_READWRITE);
  std::string names;
  for (std::size_t i = 0; i < columns().size() - added.size(); ++i)
    names += (i == 0 ? "" : ", ") + std::string(columns()[i].name);
  SQLite::Statement insert(older, fmt::format("INSERT INTO solves ({0}) SELECT {1} FROM solves WHERE run = 1", names,
                                              std::string(names).replace(names.find(" run,"), 5, " 21,")));
  { const Store store(file, Store::Mode::write); }
  insert.exec();
  SolveRecord expected = as_of(full_record("key-a", 21), today);
  CHECK(same(series_of(Store(file, Store::Mode::read), "key-a").back(), expected));
}

TEST_CASE("of several programs that give a store its columns at once one does, and none loses a solve",
          "[store][columns][faults]") {
  for (int trial = 0; trial < 5; ++trial) {
    const ScratchFolder folder;
    const auto file = folder.path / "a.ikb";
    write_older(file, today);
    std::vector<pid_t> writers;
    for (int writer = 0; writer < 4; ++writer) {
      writers.push_back(in_a_process([&] {
        Store store(file, Store::Mode::write);
        store.append({full_record("key-c", 100 + writer)});
        return true;
      }));
    }
    for (const pid_t writer : writers) CHECK(exit_code(writer) == 0);
    check_solves(file, today);
    CHECK(series_of(Store(file, Store::Mode::read), "key-c").size() == 4);
    CHECK(version_of(file) == newest);
  }
}

TEST_CASE("kill -9 while a store is given columns loses nothing", "[store][columns][faults]") {
  const ScratchFolder folder;
  write_older(folder.path / "older.ikb", today);
  const auto file = folder.path / "a.ikb";
  for (int delay_us = 0; delay_us < 6000; delay_us += 300) {
    CAPTURE(delay_us);
    for (const char* end : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(file.string() + end);
    std::filesystem::copy_file(folder.path / "older.ikb", file);
    const pid_t writer = in_a_process([&] {
      const Store store(file, Store::Mode::write);
      return kill(getpid(), SIGKILL) == 0;  // before it is closed
    });
    usleep(static_cast<useconds_t>(delay_us));
    kill(writer, SIGKILL);
    CHECK(exit_code(writer) == -1);
    Store(file, Store::Mode::write).append({full_record("key-c", 1)});
    check_solves(file, today);
    CHECK(version_of(file) == newest);
  }
}

TEST_CASE("a store that was killed with half its columns has those of its version", "[store][columns][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  write_older(file, today);
  const pid_t writer = in_a_process([&] {
    SQLite::Database sqlite(file.string(), SQLite::OPEN_READWRITE);
    sqlite.exec(
        "PRAGMA journal_mode = WAL; PRAGMA cache_size = 1; BEGIN IMMEDIATE; "
        "ALTER TABLE solves ADD COLUMN start_error_cm REAL; UPDATE solves SET trace_cm = '[]'");
    return kill(getpid(), SIGKILL) == 0;
  });
  CHECK(exit_code(writer) == -1);
  REQUIRE(std::filesystem::file_size(file.string() + "-wal") > 0);
  check_solves(file, today);
  { const Store store(file, Store::Mode::write); }
  CHECK(version_of(file) == newest);
  check_solves(file, today);
}
