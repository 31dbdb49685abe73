// A store that the program of commit 4de262c wrote (tests/data), whatever columns this program has: of schema 1, with
// keys of series that tell no source, two solvers, two runs, three points. Its pages are of 1024 bytes, to be small.
#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>

#include "results/export.hpp"
#include "results/fingerprint.hpp"
#include "results/store.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;

namespace {

const std::filesystem::path original = "tests/data/store-of-4de262c.sqlite";

// What that program said of its store with `ikbench fingerprint`.
constexpr const char* fingerprint_then = "d9324994b9b925db54f4a4e4c10b55e8";

void check_contents(const Store& store) {
  const StudyEntry study = store.study("small");
  REQUIRE(study.series.size() == 2);
  CHECK(study.series[0].label == "IK-BA");
  CHECK(study.series[1].algorithm == "bat");
  CHECK(store.sessions().front().environment.at("commit") == "4de262ce89d1");
  const std::vector<SolveRecord> solves = store.solves("small");
  REQUIRE(solves.size() == 12);
  CHECK(fingerprint(solves) == fingerprint_then);
  for (const SolveRecord& solve : solves) {
    CHECK(solve.stop_reason == StopReason::iterations);
    CHECK(solve.timing == Timing::debug_build);
    CHECK(solve.session == 1);
    CHECK(solve.seconds > 0);
    CHECK(solve.trace_cm.back() == solve.claimed_error_cm);
  }
}

// Of columns that schema 1 does not have: nothing that looks like a measurement.
void check_added_columns(const SolveRecord& solve) {
  std::size_t index = 0;
  for_each_column([&]<class Value>(std::string_view name, Value SolveRecord::*member, std::string_view) {
    if (++index <= 26) return;
    CAPTURE(name);
    if constexpr (std::is_floating_point_v<Value>)
      CHECK(std::isnan(solve.*member));
    else
      CHECK(solve.*member == SolveRecord{}.*member);
  });
}

}  // namespace

TEST_CASE("a store of the program of 4de262c is read, with the numbers that it had then", "[store][older]") {
  const std::string before = text_in(original);
  const Store store(original, Store::Mode::read);
  check_contents(store);
  for (const SolveRecord& solve : store.solves("small")) check_added_columns(solve);
  CHECK(text_in(original) == before);
}

TEST_CASE("a store of the program of 4de262c is written on, and nothing in it is lost", "[store][older]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  std::filesystem::copy_file(original, file);
  {
    Store store(file, Store::Mode::write);
    store.begin_session({{"cpu", "x"}});
    store.append({sample_record("key-a", 1), sample_record("key-a", 2)});
  }
  const Store store(file, Store::Mode::read);
  check_contents(store);
  for (const SolveRecord& solve : store.solves("small")) check_added_columns(solve);
  CHECK(same(series_of(store, "key-a").back(), sample_record("key-a", 2)));
  CHECK(store.sessions().size() == 2);
  SQLite::Database sqlite(file.string());
  CHECK(sqlite.execAndGet("PRAGMA user_version").getInt64() == static_cast<std::int64_t>(columns().size()) - 25);
  CHECK(sqlite.execAndGet("PRAGMA integrity_check").getString() == "ok");
}

TEST_CASE("a damaged store of the program of 4de262c is refused", "[store][older][faults]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  const std::string whole = text_in(original);
  for (std::size_t length = 100; length < whole.size(); length += 1999) {
    write_text(file, whole.substr(0, length));
    for (const auto mode : {Store::Mode::read, Store::Mode::write}) {
      CAPTURE(length);
      CHECK_THAT(complaint<std::invalid_argument>([&] { const Store store(file, mode); }),
                 ContainsSubstring("is damaged"));
    }
  }
  for (const char* sql : {"ALTER TABLE solves DROP COLUMN trace_cm", "ALTER TABLE solves ADD COLUMN more REAL"}) {
    CAPTURE(sql);
    write_text(file, whole);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(sql);
    CHECK_THAT(complaint<std::invalid_argument>([&] { const Store store(file, Store::Mode::write); }),
               ContainsSubstring("its table solves has unexpected columns"));
  }
}
