// The lock of a paper: the set-ups that its text allows, and how many printed numbers each agrees with.
#include <stdexcept>

#include "analysis/claims/row_agreement.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::report;
using namespace ikbench::claims;
using Catch::Matchers::Contains;

namespace {

constexpr const char* two_points = R"(
study = "haviland2023-part2"
table = "part2-ur5"
solvers = ["Chan 0.1"]
[[points]]
open = "tool"
alternatives = [{ where = "the tool is the hand" }, { set = ["robot=other"], where = "the tool is the flange" }]
[[points]]
open = "order"
alternatives = [
  { where = "targets are first" },
  { set = ["path.skipped=1", "mine.skipped=0"], where = "starts are first" },
  { where = "both are mixed" },
]
)";

Lock lock_of(const std::string& text) {
  const toml::table table = numerics::parse_toml(text, "lock.toml");
  return read_lock(numerics::TomlReader(table, "lock.toml", ""), "haviland2023");
}

PrintedNumbers numbers(int integers) {
  return {.integers = 3, .agreeing_integers = integers, .numbers = 5, .agreeing = integers};
}

}  // namespace

TEST_CASE("every combination of the open points is a set-up, the study's own first", "[lock]") {
  const Lock lock = lock_of(two_points);
  CHECK(set_ups(lock) == std::vector<SetUp>{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}});
  CHECK(overrides_of(lock, {0, 0}).empty());
  CHECK(overrides_of(lock, {1, 1}) == std::vector<std::string>{"robot=other", "path.skipped=1", "mine.skipped=0"});
}

TEST_CASE("the sentence says which set-ups have the most printed integers", "[lock]") {
  const Lock lock = lock_of(two_points);
  std::vector<PrintedNumbers> found(6, numbers(1));
  CHECK_THAT(lock_sentence(lock, found),
             Contains("Of 6 set-ups that the text allows, 6 have the most printed integers, 1 of 3"));
  found[4] = numbers(3);
  CHECK_THAT(lock_sentence(lock, found),
             Contains("1 has the most printed integers, 3 of 3: the tool is the flange and starts are first."));
  found[0] = numbers(3);
  CHECK_THAT(lock_sentence(lock, found),
             Contains("2 have the most printed integers, 3 of 3: the tool is the hand and "
                      "targets are first; or the tool is the flange and starts are first."));
  const Table table = lock_table(lock, found);
  CHECK(table.rows.size() == 6);
  CHECK(table.columns.size() == 4);
}

// Printed of Chan 0.1: mean 15.52 iterations, median 8, 0 infeasible, mean 1.21 searches, most 14.
TEST_CASE("solves agree with as many printed numbers as they round to", "[lock]") {
  const Lock lock = lock_of(two_points);
  SolveRecord solve{.solver = "Chan 0.1", .iterations = 8, .stop_reason = StopReason::finished};
  std::vector<SolveRecord> solves(3, solve);
  solves[1].restarts = 13;
  solves[2].solver = "another";
  PrintedNumbers found = lock.compared(solves);  // median, infeasible and most searches agree, the means do not
  CHECK(found.integers == 3);
  CHECK(found.agreeing_integers == 3);
  CHECK(found.numbers == 5);
  CHECK(found.agreeing == 3);
  solves[0].stop_reason = StopReason::gave_up;
  found = lock.compared(solves);
  CHECK(found.agreeing_integers == 2);
}

TEST_CASE("a table without integers is held against the range of chance", "[lock]") {
  const toml::table table = numerics::parse_toml(R"(
study = "lloyd2022"
table = "kr6"
solvers = ["QuIK"]
[[points]]
open = "start"
alternatives = [{ where = "it is 0" }, { set = ["start=random"], where = "it is drawn" }]
)",
                                                 "lock.toml");
  const Lock lock = read_lock(numerics::TomlReader(table, "lock.toml", ""), "lloyd2022");
  std::vector<SolveRecord> solves(1000, SolveRecord{.solver = "QuIK"});  // printed: 0.13 %
  const PrintedNumbers near = lock.compared(solves);
  CHECK(near.integers == 0);
  CHECK(near.numbers == 1);
  CHECK(near.by_chance == 1);
  for (std::size_t i = 0; i < 100; ++i) solves[i].status = Status::tolerance_missed;
  const PrintedNumbers far = lock.compared(solves);
  CHECK(far.by_chance == 0);
  CHECK(
      lock_sentence(lock, std::vector{far, near}) ==
      "Of 2 set-ups that the text allows, 1 has the most printed numbers within the range of chance, 1 of 1: it is drawn.");
  CHECK(readable(lock_table(lock, std::vector{far, near}).rows[1][2]) == "1 of 1");
}

TEST_CASE("a lock names rows that are printed", "[lock]") {
  std::string text = two_points;
  text.replace(text.find("Chan 0.1"), 8, "Nobody's");
  CHECK_THROWS_WITH(lock_of(text), Contains("has no row \"Nobody's\""));
}
