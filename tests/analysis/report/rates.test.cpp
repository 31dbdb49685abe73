// Studies that are read together: a row an arm, a share and its interval a solver.
#include "analysis/report/rates.hpp"

#include <algorithm>

#include "analysis/inference/make_study.hpp"
#include "analysis/report/paper.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

// Ten poses, so many of which each of the two solves.
JudgedStudy study_of(const std::string& robot, int solved_by_a, int solved_by_b) {
  std::vector<SolveRecord> solves;
  for (int run = 1; run <= 10; ++run) {
    for (const auto& [solver, solved] : {std::pair("A", solved_by_a), std::pair("B", solved_by_b)}) {
      SolveRecord solve{.solver = solver, .run = run};
      solve.robot = robot;
      solve.status = run <= solved ? Status::ok : Status::tolerance_missed;
      solves.push_back(solve);
    }
  }
  return JudgedStudy(make_study(robot, std::move(solves)));
}

StudyPieces pieces_of(const JudgedStudy& first, JudgedStudies companions = {}) {
  const Collection collection{.name = "arms", .rates = {.level = 0.95}};
  return report::pieces_of(Reported{first, std::move(companions)}, collection);
}

const Table& table_of(const StudyPieces& pieces) {
  return *std::ranges::find(pieces.tables, "solve-rates", &Table::name);
}

}  // namespace

TEST_CASE("each arm has a row, with the share that each solver solves and Wilson's interval", "[arms]") {
  const JudgedStudy iiwa = study_of("kuka_iiwa14", 8, 10), stanford = study_of("stanford", 0, 5);
  const StudyPieces pieces = pieces_of(iiwa, {stanford});
  CHECK(pieces.results == "solve-rates");
  const Table& table = table_of(pieces);
  std::vector<std::string> heads;
  for (const std::string& column : table.columns) heads.push_back(column);
  CHECK(heads == std::vector<std::string>{"arm", "A", "A, interval", "B", "B, interval"});
  REQUIRE(table.rows.size() == 2);
  const auto number = [&](std::size_t row, std::size_t column) { return std::get<double>(table.rows[row][column]); };
  const auto range = [&](std::size_t row, std::size_t column) { return std::get<Range>(table.rows[row][column]); };
  CHECK(std::get<std::string>(table.rows[0][0]) == "kuka_iiwa14");
  CHECK(std::get<std::string>(table.rows[1][0]) == "stanford");
  CHECK(number(0, 1) == Approx(80));
  CHECK(number(0, 3) == Approx(100));
  CHECK(number(1, 1) == 0);
  CHECK(number(1, 3) == Approx(50));
  // Wilson's score interval, z = 1.959964: of 8 of 10; of 10 of 10 from 1 / (1 + z^2 / 10); of 0 of 10 its mirror
  // image.
  CHECK(range(0, 2).low == Approx(49.0162472).epsilon(1e-8));
  CHECK(range(0, 2).high == Approx(94.3317849).epsilon(1e-8));
  CHECK(range(0, 4).low == Approx(72.2467200).epsilon(1e-8));
  CHECK(range(0, 4).high == Approx(100));
  CHECK(range(1, 2).low == Approx(0).margin(1e-12));
  CHECK(range(1, 2).high == Approx(27.7532800).epsilon(1e-8));
  CHECK(std::ranges::count(pieces.figures, "solve-rates-figure", &figures::Figure::name) == 1);
}

TEST_CASE("an arm that is not solved yet has no row, and a study without solves no table of arms", "[arms]") {
  const JudgedStudy none(make_study("arms-puma560", std::vector<SolveRecord>{})), iiwa = study_of("kuka_iiwa14", 8, 10);
  CHECK(table_of(pieces_of(iiwa, {none})).rows.size() == 1);
  CHECK(std::ranges::count(pieces_of(none).tables, "solve-rates", &Table::name) == 0);
}

// Differences of 10, 20 (twice), 30 (six times) and 40 %: mean 27, standard deviation 8.233, and Student's t with 9
// degrees of freedom is 2.2622. A new arm: 27 +- 2.2622 * 8.233 * sqrt(1.1) = 27 +- 19.53.
TEST_CASE("over arms, an arm is one observation, and a new arm has a wider interval", "[arms]") {
  std::vector<JudgedStudy> all;
  for (const int ahead : {1, 2, 2, 3, 3, 3, 3, 3, 3, 4})
    all.push_back(study_of("arm" + std::to_string(all.size()), 5 + ahead, 5));
  const StudyPieces pieces = pieces_of(all.front(), {all.begin() + 1, all.end()});
  const Table& table = *std::ranges::find(pieces.tables, "over-arms", &Table::name);
  REQUIRE(table.rows.size() == 1);
  const std::vector<Cell>& row = table.rows[0];
  CHECK(readable(row[0]) == "A");
  CHECK(readable(row[1]) == "B");
  CHECK(std::get<double>(row[3]) == Approx(27));
  const Range mean = std::get<Range>(row[4]), fresh = std::get<Range>(row[6]);
  CHECK(mean.low > fresh.low);
  CHECK(mean.high < fresh.high);
  CHECK(fresh.low == Approx(27 - 19.53).margin(0.01));
  CHECK(fresh.high == Approx(27 + 19.53).margin(0.01));
  CHECK(readable(row[7]) == "10 of 10");
  REQUIRE(pieces.verdict.size() == 1);
  CHECK(pieces.verdict[0].topic == "Most solved poses over 10 arms");
}

TEST_CASE("an arm without which the verdict is another is named", "[arms]") {
  std::vector<JudgedStudy> all;
  for (int i = 0; i < 7; ++i) all.push_back(study_of("arm" + std::to_string(i), 8 + i % 2, 5 + i % 3 % 2));
  all.push_back(study_of("odd", 1, 8));
  const StudyPieces pieces = pieces_of(all.front(), {all.begin() + 1, all.end()});
  const Table& table = *std::ranges::find(pieces.tables, "over-arms", &Table::name);
  CHECK(readable(table.rows[0][2]) == "undecided");
  CHECK(readable(table.rows[0][8]) == "odd");
}

TEST_CASE("two arms have no verdict over arms", "[arms]") {
  const JudgedStudy one = study_of("one", 10, 8), two = study_of("two", 9, 6);
  const StudyPieces pieces = pieces_of(one, {two});
  CHECK(pieces.verdict.empty());
  CHECK(std::ranges::find(pieces.tables, "over-arms", &Table::name) == pieces.tables.end());
}
