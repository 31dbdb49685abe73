// A program with five more columns (tests/examples/results/columns.inc).
#include <SQLiteCpp/SQLiteCpp.h>

#include "results/csv.hpp"
#include "results/export.hpp"
#include "results/fingerprint.hpp"
#include "results/store.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;

namespace {

SolveRecord full_record(const std::string& series, int run) {
  SolveRecord record = sample_record(series, run);
  record.start_error_cm = 0.125;
  record.repetitions = 5;
  record.timing_before = Timing::parallel;
  record.remark = "'quoted'";
  record.all_seconds = {0.125, 0.25};
  return record;
}

}  // namespace

TEST_CASE("a line of columns.inc is a column everywhere", "[store][columns]") {
  const std::vector<ColumnInfo> all = columns(), list(all.end() - 5, all.end());
  CHECK(list[0].name == "start_error_cm");
  CHECK(list[0].meaning == "distance to the target before the solve [cm]");
  CHECK(list[1].type == "integer");
  CHECK(list[2].type == "name");
  CHECK(list[4].type == "list of numbers");

  const CsvTable csv = parse_csv(exported("csv", {full_record("key-a", 1)}), "a.csv");
  CHECK(csv.rows[0][csv.column("start_error_cm")] == "0.125");
  CHECK(csv.rows[0][csv.column("repetitions")] == "5");
  CHECK(csv.rows[0][csv.column("timing_before")] == "parallel");
  CHECK(csv.rows[0][csv.column("remark")] == "'quoted'");
  CHECK(csv.rows[0][csv.column("all_seconds_2")] == "0.25");
  CHECK_THAT(exported("json", {full_record("key-a", 1)}),
             ContainsSubstring(R"("start_error_cm":0.125,"repetitions":5,"timing_before":"parallel",)"
                               R"("remark":"'quoted'","all_seconds":[0.125,0.25]})"));
}

TEST_CASE("a column that is added is not in the fingerprint", "[store][columns]") {
  CHECK(fingerprint({full_record("key-a", 1)}) == fingerprint({sample_record("key-a", 1)}));
}

TEST_CASE("a column that is added is in the store", "[store][columns]") {
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  Store(file, Store::Mode::write).append({full_record("key-a", 1)});
  CHECK(same(series_of(Store(file, Store::Mode::read), "key-a").front(), full_record("key-a", 1)));
}

TEST_CASE("a column that is added is a version more, and a store of the version before is refused",
          "[store][columns]") {
  const auto newest = static_cast<std::int64_t>(columns().size()) - 25;
  const ScratchFolder folder;
  const auto file = folder.path / "a.ikb";
  { const Store store(file, Store::Mode::write); }
  {
    SQLite::Database sqlite(file.string(), SQLite::OPEN_READWRITE);
    CHECK(sqlite.execAndGet("PRAGMA user_version").getInt64() == newest);
    sqlite.exec(fmt::format("ALTER TABLE solves DROP COLUMN all_seconds; PRAGMA user_version = {}", newest - 1));
  }
  CHECK_THAT(
      complaint<std::invalid_argument>([&] { const Store store(file, Store::Mode::read); }),
      ContainsSubstring(fmt::format("has schema {}, but this ikbench reads schema {} alone", newest - 1, newest)));
}
