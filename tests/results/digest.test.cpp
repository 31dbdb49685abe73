// Every change of a store after it was written shows.
#include "results/digest.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <signal.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <type_traits>
#include <utility>

#include "results/looks.hpp"
#include "results/merge.hpp"
#include "tests/catch.hpp"
#include "tests/results/processes.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;

namespace {

namespace fs = std::filesystem;

// Two sessions with solves of the sample study, as a program writes them.
void write_sample(const fs::path& file, const std::string& machine = "one") {
  Store store(file, Store::Mode::write);
  store.save_study(sample_study());
  for (const int first : {1, 4}) {
    const std::int64_t session = store.begin_session({{"machine", machine}, {"study", "table-3"}});
    for (int run = first; run < first + 3; ++run) {
      SolveRecord record = sample_record("key-a", run);
      record.session = session;
      store.append({record});
    }
    store.add_to_session(session, {{"stolen_seconds", "0.5"}});
  }
}

void tamper(const fs::path& file, const std::string& sql) {
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(sql);
}

// Changes of a store after reading the solves of a series, if there is one.
std::string changes_of(const fs::path& file, const std::string& series = "") {
  const Store store(file, Store::Mode::read);
  if (!series.empty()) store.each_of_series(series, [](const SolveRecord&) {});
  return fmt::format("{}", fmt::join(store.changes({"table-3"}).sentences, "; "));
}

template <class Value>
Value changed(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return static_cast<Value>(value == Value{} ? 1 : 0);
  else if constexpr (std::is_same_v<Value, std::string>)
    return value + 'x';
  else if constexpr (std::is_same_v<Value, std::vector<double>>)
    return value.empty() ? Value{1} : Value(value.begin() + 1, value.end());
  else
    return value == value ? value + 1 : Value{};
}

}  // namespace

TEST_CASE("a digest follows every column but study, session and itself", "[digest]") {
  const std::int64_t digest = digest_of(sample_record());
  CHECK(digest > 0);
  CHECK(digest <= std::numeric_limits<std::uint32_t>::max());
  for_each_column([&](std::string_view name, auto member, std::string_view) {
    CAPTURE(name);
    SolveRecord record = sample_record();
    record.*member = changed(record.*member);
    CHECK((digest_of(record) != digest) == (name != "study" && name != "session" && name != "digest"));
  });
}

TEST_CASE("a digest follows every place and bit of what is in a list or a text", "[digest]") {
  std::vector<std::int64_t> digests;
  const auto note = [&](const SolveRecord& record) { digests.push_back(digest_of(record)); };
  for (std::size_t i = 0; i < 7; ++i) {
    SolveRecord record = sample_record();
    record.answer_rad[i] = std::nextafter(record.answer_rad[i], 9);
    note(record);
  }
  for (const char* text : {"", "a", "b", "ab", "ba", "aaaaaaaa", "aaaaaaaab", "baaaaaaaa"}) {
    SolveRecord record = sample_record();
    record.robot = text;
    note(record);
    std::swap(record.robot, record.solver);
    note(record);
  }
  std::ranges::sort(digests);
  CHECK(std::ranges::adjacent_find(digests) == digests.end());
}

TEST_CASE("a solve comes back with the digest of what comes back", "[digest]") {
  const ScratchFolder folder;
  SolveRecord record = sample_record();
  record.position_error_cm = -0.0;
  record.seconds = std::numeric_limits<double>::quiet_NaN();
  record.trace_cm = {-0.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  record.robot = std::string("nul\0inside", 10);
  record.digest = 7;
  Store(folder.path / "a", Store::Mode::write).append({record});
  const SolveRecord again = series_of(Store(folder.path / "a", Store::Mode::read), "key-a").front();
  CHECK(again.digest == digest_of(again));
  CHECK(again.digest == digest_of(record));
}

TEST_CASE("a store as it was written has no changes, and what was changed in it is told", "[digest][store]") {
  const std::vector<std::pair<std::string, std::string>> edits{
      {"", ""},
      {"UPDATE sessions SET id = id", ""},
      {"UPDATE studies SET definition = replace(definition, '20', '19')", "the definition of study 'table-3', its"},
      {"UPDATE series SET label = 'ik' WHERE position = 1", "its series or its looks were changed"},
      {"UPDATE series SET options = '{}' WHERE position = 1", "its series or its looks were changed"},
      {"DELETE FROM series WHERE position = 2", "its series or its looks were changed"},
      {"UPDATE environment SET value = 'two' WHERE session = 2 AND key = 'machine'", "session 2 of "},
      {"UPDATE environment SET value = 7 WHERE session = 2 AND key = 'stolen_seconds'", "what is known of it, or"},
      {"DELETE FROM environment WHERE key = 'machine'", "session 1 of "},
      {"INSERT INTO environment VALUES (1, 'source', 'x')", "session 1 of "},
      {"UPDATE sessions SET began = '2020-01-01T00:00:00Z' WHERE id = 1",
       "session 1 of '2020-01-01T00:00:00Z' was changed since"},
      {"DELETE FROM solves WHERE run = 2", "session 1 of "},
      {"DELETE FROM solves WHERE run = 2", "it has 2 solves, and '3' were stored"},
      {"DELETE FROM solves WHERE session = 2", "it has 0 solves, and '3' were stored"},
      {"UPDATE solves SET session = 2 WHERE run = 3", "it has 4 solves, and '3' were stored"},
      {"UPDATE solves SET digest = 0 WHERE run = 3", "session 1 of "},
      {"UPDATE solves SET run = 300 WHERE run = 3", "session 1 of "},
      {"UPDATE solves SET point = 300 WHERE run = 3", "session 1 of "},
      {"UPDATE solves SET series = 'key-c' WHERE run = 3", "session 1 of "},
      {"UPDATE solves SET study = 'table-4' WHERE run = 3", "session 1 of "},
      {"DELETE FROM meta WHERE key = 'digest of session 1'", "it has lost its digest"},
      {"DELETE FROM meta WHERE key = 'solves of session 1'", "it has lost the number of its solves"},
      {"UPDATE meta SET value = 'x' WHERE key = 'digest of session 1'", "session 1 of "}};
  for (const auto& [sql, words] : edits) {
    CAPTURE(sql);
    const ScratchFolder folder;
    write_sample(folder.path / "a");
    tamper(folder.path / "a", sql);
    const std::string found = changes_of(folder.path / "a");
    if (words.empty())
      CHECK(found.empty());
    else
      CHECK_THAT(found, ContainsSubstring(words));
    CHECK(changes_of(folder.path / "a", "key-a") == found);  // the solves are read first, and only once
    CHECK(changes_of(folder.path / "a", "key-b") == found);
  }
}

TEST_CASE("what is written while the solves are read is no change, and what is edited is", "[digest][store]") {
  for (const char* sql :
       {"", "UPDATE solves SET point = 300 WHERE run = 9", "UPDATE solves SET point = 300 WHERE run = 3"}) {
    CAPTURE(sql);
    const ScratchFolder folder;
    write_sample(folder.path / "a");
    Store(folder.path / "a", Store::Mode::write).append({sample_record("key-b", 3)});
    tamper(folder.path / "a", std::string(sql).ends_with('3') ? sql : "");
    const Store store(folder.path / "a", Store::Mode::read);
    bool is_first = true;
    store.each_of_series("key-a", [&](const SolveRecord&) {
      if (!std::exchange(is_first, false)) return;
      Store(folder.path / "a", Store::Mode::write).append({sample_record("key-a", 9), sample_record("key-b", 9)});
    });
    tamper(folder.path / "a", sql);
    CHECK(store.changes({"table-3"}).sentences.size() == (*sql == '\0' ? 0 : 1));
  }
}

TEST_CASE("a look that was removed, edited or made up is a change of its study", "[digest][store][looks]") {
  const std::vector<std::pair<std::string, std::string>> edits{
      {"", ""},
      {"DELETE FROM meta WHERE key = 'look after 3 runs: table-3'", "its looks"},
      {"DELETE FROM meta WHERE key GLOB '*look*'", "its looks"},
      {"UPDATE meta SET value = '2020-01-01T00:00:00Z' WHERE key = 'look after 3 runs: table-3'", "its looks"},
      {"UPDATE meta SET key = 'look after 7 runs: table-3' WHERE key = 'look after 3 runs: table-3'", "its looks"},
      {"INSERT INTO meta VALUES ('look after 2 runs: table-3', '2020-01-01T00:00:00Z')", "its looks"}};
  for (const auto& [sql, words] : edits) {
    CAPTURE(sql);
    const ScratchFolder folder;
    write_sample(folder.path / "a");
    for (const int runs : {3, 6, 6}) remember_look("table-3", runs, folder.path / "a");
    CHECK(looks_at("table-3", folder.path / "a").size() == 2);
    Store(folder.path / "a", Store::Mode::write).save_study(sample_study());
    CHECK(changes_of(folder.path / "a").empty());
    tamper(folder.path / "a", sql);
    for (int time = 0; time < 2; ++time) {
      CHECK(changes_of(folder.path / "a").empty() == words.empty());
      CHECK_THAT(changes_of(folder.path / "a"), ContainsSubstring(words));
      StudyEntry larger = sample_study();
      larger.definition = R"({"robot":"iiwa14","runs":30,"points":20})";
      Store(folder.path / "a", Store::Mode::write).save_study(larger);  // adds runs
    }
  }
}

TEST_CASE("a store that a killed look left half-written is whole for the next", "[looks][faults]") {
  const ScratchFolder folder;
  const fs::path file = folder.path / "a";
  write_sample(file);
  std::vector<SolveRecord> records;
  for (int run = 10; run < 50; ++run) records.push_back(sample_record("key-a", run));
  Store(file, Store::Mode::write).append(records);
  const pid_t writer = in_a_process([&] {
    SQLite::Database sqlite(file.string(), SQLite::OPEN_READWRITE);
    sqlite.exec("PRAGMA cache_size = 1; BEGIN; UPDATE solves SET trace_cm = '[1]'; UPDATE solves SET trace_cm = '[2]'");
    return kill(getpid(), SIGKILL) == 0;
  });
  CHECK(exit_code(writer) == -1);
  CHECK_THROWS_AS(Store(file, Store::Mode::read), HalfWritten);
  CHECK(open_to_look(file).studies().size() == 1);
  CHECK(changes_of(file).empty());
}

TEST_CASE("looks of merged stores are those of all, and no change", "[digest][merge][looks]") {
  const ScratchFolder folder;
  for (const char* name : {"a", "b"}) write_sample(folder.path / name, name);
  remember_look("table-3", 3, folder.path / "a");
  remember_look("table-3", 3, folder.path / "b");
  remember_look("table-3", 6, folder.path / "b");
  for (const char* name : {"a", "b", "b"}) {
    merge(folder.path / "out", {folder.path / name});
    CHECK(changes_of(folder.path / "out").empty());
  }
  CHECK(looks_at("table-3", folder.path / "out").size() == 2);
}

TEST_CASE("sessions of other studies are theirs", "[digest][store]") {
  const ScratchFolder folder;
  write_sample(folder.path / "a");
  {
    Store store(folder.path / "a", Store::Mode::write);
    StudyEntry other = sample_study("other");
    for (Series& series : other.series) series.key += "-of-other";
    store.save_study(other);
    store.begin_session({{"study", "other"}});
  }
  tamper(folder.path / "a", "UPDATE environment SET value = 'x' WHERE session = 1 AND key = 'machine'");
  const Store store(folder.path / "a", Store::Mode::read);
  CHECK(store.changes({"other"}).sentences.empty());
  CHECK(store.changes({"table-3"}).sentences.size() == 1);
  CHECK(store.changes({"table-3", "other"}).sentences.size() == 1);
}

TEST_CASE("whatever a killed program has stored fits its digests", "[digest][store][faults]") {
  for (const int runs : {0, 1, 7}) {
    const ScratchFolder folder;
    const pid_t writer = in_a_process([&] {
      Store store(folder.path / "a", Store::Mode::write);
      store.save_study(sample_study());
      const std::int64_t session = store.begin_session({{"study", "table-3"}});
      for (int run = 1; run <= runs; ++run) {
        SolveRecord record = sample_record("key-a", run);
        record.session = session;
        store.append({record});
      }
      return kill(getpid(), SIGKILL) == 0;
    });
    CHECK(exit_code(writer) == -1);
    CHECK(changes_of(folder.path / "a").empty());
    CHECK(Store(folder.path / "a", Store::Mode::read).changes({"table-3"}).are_known);
  }
}

TEST_CASE("a merged store fits its digests, however often and from what it was merged", "[digest][merge]") {
  const ScratchFolder folder;
  write_sample(folder.path / "a");
  write_sample(folder.path / "b", "two");
  tamper(folder.path / "b",
         "UPDATE solves SET run = run + 10, digest = 0; DELETE FROM meta WHERE key GLOB '* session *'");
  fs::copy_file(folder.path / "a", folder.path / "half");
  {
    SolveRecord later = sample_record("key-b");
    later.session = 2;
    Store store(folder.path / "a", Store::Mode::write);
    store.append({later});
    store.add_to_session(2, {{"program.BA", "it ended"}});
  }
  merge(folder.path / "out", {folder.path / "a"});
  for (int time = 0; time < 2; ++time) {
    merge(folder.path / "out", {folder.path / "half", folder.path / "a"});
    CHECK(changes_of(folder.path / "out").empty());
    CHECK(Store(folder.path / "out", Store::Mode::read).changes({"table-3"}).are_known);
  }
  merge(folder.path / "out", {folder.path / "b"});
  CHECK(changes_of(folder.path / "out").empty());
  CHECK_FALSE(Store(folder.path / "out", Store::Mode::read).changes({"table-3"}).are_known);
  tamper(folder.path / "out", "DELETE FROM solves WHERE run = 2");
  CHECK_THAT(changes_of(folder.path / "out"), ContainsSubstring("solves, and '"));
}

TEST_CASE("what was changed is not merged, whichever of the stores it is", "[digest][merge]") {
  const ScratchFolder folder;
  for (const char* name : {"a", "b"}) write_sample(folder.path / name);
  merge(folder.path / "out", {folder.path / "a"});
  tamper(folder.path / "b", "DELETE FROM solves WHERE run = 2");
  const auto merged_with = [&](const char* out, const char* store) {
    return complaint<std::invalid_argument>([&] { merge(folder.path / out, {folder.path / store}); });
  };
  const std::string words = quoted(folder.path / "b") + " was changed since it was written: session 1 of ";
  CHECK_THAT(merged_with("out", "b"), ContainsSubstring(words));
  CHECK_THAT(merged_with("b", "a"), ContainsSubstring(words));
  CHECK_THAT(merged_with("new", "b"), ContainsSubstring(words));
  CHECK_FALSE(fs::exists(folder.path / "new"));
}

TEST_CASE("digests of a million solves cost less than a second where the solves are read", "[digest][.speed]") {
  const ScratchFolder folder;
  write_sample(folder.path / "a");
  tamper(
      folder.path / "a",
      "WITH RECURSIVE n(i) AS (SELECT 100 UNION ALL SELECT i + 1 FROM n WHERE i < 1000099) INSERT INTO solves SELECT " +
          [] {
            std::string columns;
            for_each_column([&](std::string_view name, auto, std::string_view) {
              columns += (columns.empty() ? "" : ", ") + std::string(name == "run" ? "i" : name);
            });
            return columns;
          }() +
          " FROM n, (SELECT * FROM solves LIMIT 1)");
  const auto timed = [](auto&& action) {
    const std::clock_t began = std::clock();
    action();
    return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  };
  const Store store(folder.path / "a", Store::Mode::read);
  int solves = 0;
  const double read = timed([&] { store.each_of_series("key-a", [&](const SolveRecord&) { ++solves; }); });
  CHECK(solves > 1'000'000);
  const double read_again = timed([&] { store.each_of_series("key-a", [&](const SolveRecord&) { --solves; }); });
  Changes changes;
  const double held = timed([&] { changes = store.changes({"table-3"}); });
  REQUIRE(changes.sentences.size() == 1);
  CHECK_THAT(changes.sentences[0], ContainsSubstring("it has 10000"));
  std::int64_t digests = 0;
  const SolveRecord record = sample_record();
  const double digested = timed([&] {
    for (int i = 0; i < 1'000'000; ++i) digests += digest_of(record);
  });
  CAPTURE(read, read_again, held, digested, digests);
  CHECK(read - read_again + held + digested < 1);  // they are summed up the first time
  WARN(
      fmt::format("a million solves: {:.2f} s to read and sum up, {:.2f} s to read, {:.2f} s to hold the sums against "
                  "those written, {:.2f} s to make digests",
                  read, read_again, held, digested));
}
