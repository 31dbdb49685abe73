// Printed rows beside ours, for solves made by hand: every digit, rounding, chance, outside, not attempted.
#include "analysis/claims/row_agreement.hpp"

#include <algorithm>

#include "analysis/inference/make_study.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::claims;

namespace {

// Solves of a row of part2-ur5 (results/published/haviland2023): mean 15.52 iterations, median 8, 0 infeasible, mean
// 1.21 searches, most 14.
struct Searches {
  std::string solver = "Chan 0.1";
  int iterations = 0, restarts = 0;
  bool gave_up = false;
};

StudyResults study_of(const std::string& name, const std::vector<Searches>& all, int perturbed = 0) {
  std::vector<SolveRecord> solves;
  int point = 0;
  for (const Searches& each : all) {
    SolveRecord solve{.solver = each.solver, .run = 1, .point = ++point};
    solve.iterations = each.iterations;
    solve.restarts = each.restarts;
    solve.stop_reason = each.gave_up ? StopReason::gave_up : StopReason::finished;
    solves.push_back(solve);
  }
  StudyResults study = make_study(name, std::move(solves));
  study.facts.perturbed = perturbed;
  return study;
}

// 100 solves with a mean of `hundredths` / 100 iterations, median 8, 121 searches in all and 14 at most.
std::vector<Searches> as_printed(int hundredths) {
  std::vector<Searches> all(100, Searches{.iterations = 8});
  all[0].iterations += hundredths - 800;
  all[0].restarts = 13;
  for (std::size_t i = 1; i <= 8; ++i) all[i].restarts = 1;
  return all;
}

const std::vector<PrintedTable> plan{
    {.study = "ours", .table = "part2-ur5", .caption = "UR5", .not_attempted = {{"QP", "why"}}}};

std::vector<Cell> row_of(const Table& table, const std::string& solver) {
  return *std::ranges::find_if(table.rows, [&](const std::vector<Cell>& row) { return readable(row[0]) == solver; });
}

}  // namespace

TEST_CASE("a row agrees in every digit, or by how many numbers", "[rows]") {
  const JudgedStudy equal(study_of("ours", as_printed(1552)));
  const StudyPieces rows = compared_rows({equal}, "haviland2023", plan);
  REQUIRE(rows.tables.size() == 1);
  const std::vector<Cell> row = row_of(rows.tables[0], "Chan 0.1");
  CHECK(readable(row[1]) == "every digit");
  CHECK(readable(row[2]) == "15.52 (printed 15.52)");
  CHECK(readable(row[5]) == "1.21 (printed 1.21)");
  CHECK(contains(rows.verdict.front().text, "1 of 1 repeated rows of the printed tables agree in every digit."));
  CHECK(contains(rows.verdict.front().text, "4 rows were not attempted."));
  CHECK(readable(row_of(rows.tables[0], "QP")[1]) == "not attempted: why");

  const JudgedStudy near(study_of("ours", as_printed(1560)));
  const StudyPieces by_chance = compared_rows({near}, "haviland2023", plan);
  CHECK(contains(by_chance.verdict.front().text,
                 "0 are within the range of rounding, 1 within the range of chance and 0 outside"));
  CHECK(contains(readable(row_of(by_chance.tables[0], "Chan 0.1")[1]), "4 of 5 numbers agree"));

  std::vector<Searches> others(100, Searches{.iterations = 30});
  const JudgedStudy far(study_of("ours", others));
  CHECK(contains(compared_rows({far}, "haviland2023", plan).verdict.front().text,
                 "0 within the range of chance and 1 outside"));
}

TEST_CASE("a number that copies with other last bits reach is within the range of rounding", "[rows]") {
  const JudgedStudy study(study_of("ours", as_printed(1560)));
  Reported reported{study};
  reported.perturbed = {study_of("ours-perturbed-1", as_printed(1550), 1)};
  const StudyPieces rows = compared_rows(reported, "haviland2023", plan);
  CHECK(contains(rows.verdict.front().text, "Of the others 1 are within the range of rounding"));
  CHECK(readable(row_of(rows.tables[0], "Chan 0.1")[2]) == "15.60 (printed 15.52: rounding gives 15.5 to 15.6)");
}

TEST_CASE("who gave up counts as infeasible, and not in means", "[rows]") {
  std::vector<Searches> all = as_printed(1552);
  all.push_back({.iterations = 3100, .restarts = 99, .gave_up = true});
  const JudgedStudy study(study_of("ours", all));
  const std::vector<Cell> row = row_of(compared_rows({study}, "haviland2023", plan).tables[0], "Chan 0.1");
  CHECK(readable(row[2]) == "15.52 (printed 15.52)");
  CHECK(readable(row[6]) == "14 (printed 14)");
  CHECK(readable(row[4]).starts_with("1 (printed 0"));
}

// kr6 of lloyd2022 prints 38 us and 1 % for NR, 21 us and 0.13 % for QuIK, 5.3 % for KDL-LMA.
TEST_CASE("shares of what is not solved are held against Wilson's interval, and times against one solver's", "[rows]") {
  const auto with = [](const std::string& solver, int solves, int missed, double seconds) {
    std::vector<SolveRecord> all;
    for (int point = 1; point <= solves; ++point) {
      SolveRecord solve{.solver = solver, .run = 1, .point = point};
      solve.status = point <= missed ? Status::tolerance_missed : Status::ok;
      solve.seconds = seconds;
      all.push_back(solve);
    }
    return all;
  };
  std::vector<SolveRecord> ours = with("NR", 1000, 11, 40e-6);
  std::ranges::copy(with("QuIK", 1000, 0, 20e-6), std::back_inserter(ours));
  const JudgedStudy study(make_study("ours", ours)), beside(make_study("ours-kdl", with("KDL-LMA", 1000, 200, 80e-6)));
  Reported reported{study};
  reported.companions.emplace_back(beside);
  const std::vector<PrintedTable> kr6{
      {.study = "ours", .table = "kr6", .caption = "KR6", .beside = "ours-kdl", .times_to = "NR"}};
  const StudyPieces rows = compared_rows(reported, "lloyd2022", kr6);
  const Table& table = rows.tables.at(0);
  CHECK(readable(row_of(table, "NR")[2]) == "1 (printed 1)");
  CHECK(readable(row_of(table, "QuIK")[2]) == "0.00 (printed 0.13: chance gives 0 to 0.383)");  // 3.84 / (1000 + 3.84)
  CHECK(contains(readable(row_of(table, "KDL-LMA")[2]), "outside"));
  CHECK(readable(row_of(table, "QuIK")[3]) == "0.50 (printed 0.55)");
  CHECK(readable(row_of(table, "KDL-LMA")[3]) == "2.00 (printed 3.89)");
  CHECK(readable(row_of(table, "BFGS")[3]) == "0.89");
  CHECK(contains(rows.verdict.front().text, "1 of 3 repeated rows"));
  CHECK(contains(rows.verdict.front().text, "1 within the range of chance and 1 outside"));
}
