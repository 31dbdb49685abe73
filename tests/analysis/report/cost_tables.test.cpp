#include "analysis/report/cost_tables.hpp"

#include <limits>
#include <optional>
#include <sstream>

#include "analysis/figures/convergence_figures.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/make_study.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::figures;
using namespace ikbench::report;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
const char* const independent = R"({"stop": {"tolerance_cm": 0.1}, "path": {"kind": "random"}, "start": "initial"})";
const char* const chained = R"({"stop": {"tolerance_cm": 0.1}, "path": {"kind": "helix"}, "start": "previous"})";

// Eight solves of one solver in two runs, each of another target, of which five reach the tolerance. By hand: ERT 4320
// / 5 = 864.
std::vector<SolveRecord> eight_records() {
  const std::vector<std::int64_t> evaluations{120, 340, 80, 1000, 1000, 560, 1000, 220};
  const std::vector<double> error_cm{0.05, 0.1, 0, 0.2, 3, 0.01, not_a_number, 0.09};
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"A"}, .runs = 2, .points = 4});
  for (std::size_t i = 0; i < solves.size(); ++i) {
    solves[i].evaluations = evaluations[i];
    solves[i].position_error_cm = error_cm[i];
    if (!(error_cm[i] <= 0.1))
      solves[i].status = std::isnan(error_cm[i]) ? Status::not_finite : Status::tolerance_missed;
    solves[i].target_position_m = {0.1 * static_cast<double>(i), 0, 0.5};
  }
  return solves;
}

StudyResults study_of(std::vector<SolveRecord> solves, const char* definition) {
  StudyResults study = make_study("eight", std::move(solves));
  study.facts = facts_of(definition);
  return study;
}

StudyResults eight_solves(const char* definition) { return study_of(eight_records(), definition); }

Table evaluations_table(const StudyResults& study) {
  const std::vector<Table> tables = cost_tables(study);
  REQUIRE(!tables.empty());
  CHECK(tables.front().name == "statistics-cost");
  return tables.front();
}

}  // namespace

TEST_CASE("what a tolerance costs is what all solves spend by those that are ok", "[cost]") {
  const Table table = evaluations_table(eight_solves(independent));
  CHECK(number_at(table, 0, "solves") == 8);
  CHECK(number_at(table, 0, "solved") == 5);
  CHECK(number_at(table, 0, "ert") == Approx(864));
  CHECK(table.caption == "Cost of an answer within 0.1 cm and inside the joint limits: evaluations");
  StudyResults study = eight_solves(independent);
  study.solves.to_change().front().status = Status::limit_violated;
  CHECK(number_at(evaluations_table(study), 0, "solved") == 4);
  CHECK(number_at(evaluations_table(study), 0, "ert") == Approx(4320.0 / 4));
}

TEST_CASE("the cost of a solver that solves nothing is infinite, and those of others are as without it", "[cost]") {
  std::vector<SolveRecord> solves = eight_records();
  for (SolveRecord solve : eight_records()) {  // given up at once
    solve.solver = "B";
    solve.series = "series-b";
    solve.evaluations = 1;
    solve.status = Status::tolerance_missed;
    solves.push_back(solve);
  }
  const std::vector<Table> tables = cost_tables(study_of(std::move(solves), independent));
  CHECK(number_at(tables.front(), 0, "ert") == Approx(864));
  CHECK(readable(cell_at(tables.front(), 1, "ert")) == "inf");
  CHECK(is_empty(tables.front(), 1, "ert interval"));
  CHECK(!has_note(tables.front(), "Not defined for B"));
  REQUIRE(tables[2].name == "statistics-cost-pairs");
  CHECK(number_at(tables[2], 0, "ert ratio") == 0);
  CHECK(readable(cell_at(tables[2], 0, "spends less")) == "not defined");
  CHECK(readable(cell_at(tables[2], 0, "remark")) == "8 targets, and intervals need 10");
}

TEST_CASE("costs in seconds are told only where times are comparable", "[cost]") {
  StudyResults study = eight_solves(independent);
  CHECK(cost_tables(study).size() == 2);
  CHECK(cost_tables(study).back().name == "statistics-cost-seconds");
  study.solves.to_change().front().timing = Timing::debug_build;
  CHECK(cost_tables(study).size() == 1);
}

TEST_CASE("without a tolerance, or without solves, there is nothing to cost", "[cost]") {
  CHECK(cost_tables(eight_solves("")).empty());
  CHECK(cost_tables(eight_solves(R"({"stop": {"tolerance_cm": 0}})")).empty());
  StudyResults study = eight_solves(independent);
  study.solves.to_change().clear();
  CHECK(cost_tables(study).empty());
}

TEST_CASE("every row has a cell for every column, and a time that is no number is said", "[cost]") {
  for (const char* definition : {independent, chained}) {
    StudyResults study = eight_solves(definition);
    study.solvers.push_back("without solves");
    study.solves.to_change().front().seconds = not_a_number;
    const std::vector<Table> tables = cost_tables(study);
    REQUIRE(tables.size() == 4);
    for (const Table& table : tables) {
      for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
    }
    for (const Table& table : {tables[0], tables[1]}) CHECK(has_note(table, "Not defined for without solves"));
    CHECK(tables[1].name == "statistics-cost-seconds");
    CHECK(has_note(tables[1], "Not defined for A"));
    CHECK(tables[2].name == "statistics-cost-pairs");
    CHECK(tables[3].name == "statistics-cost-seconds-pairs");
  }
}

namespace {

// Twenty targets of A and B: A comes to each in 100 to 290 evaluations, B in half of that, and at every fourth in
// 20000.
StudyResults twenty_targets() {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"A", "B"}, .runs = 1, .points = 20});
  for (SolveRecord& solve : solves) {
    solve.target_position_m = {0.01 * solve.point, 0, 0};
    solve.evaluations = 90 + 10 * solve.point;
    solve.position_error_cm = 0.05;
    if (solve.solver == "A") continue;
    solve.evaluations = solve.point % 4 == 0 ? 20000 : solve.evaluations / 2;
  }
  StudyResults study = make_study("twenty", std::move(solves));
  study.facts = facts_of(independent);
  return study;
}

const Table& named(const std::vector<Table>& tables, const std::string& name) {
  const auto found = std::ranges::find(tables, name, &Table::name);
  REQUIRE(found != tables.end());
  return *found;
}

}  // namespace

TEST_CASE("mean costs have intervals over targets, and none of fewer than ten", "[cost]") {
  const Table table = evaluations_table(twenty_targets());
  const auto* range = std::get_if<Range>(&cell_at(table, 0, "ert interval"));
  REQUIRE(range != nullptr);
  CHECK(number_at(table, 0, "ert") == Approx(195));
  // Student's of 20 values that are 10 apart: 195 -+ 2.093 sqrt(3500 / 20), a little more in the percentiles.
  CHECK(range->low == Approx(195 - 27.7).margin(4));
  CHECK(range->high == Approx(195 + 27.7).margin(4));
  CHECK(has_note(table, "1000 bootstrap samples of the targets"));
  const Table few = evaluations_table(eight_solves(independent));
  CHECK(is_empty(few, 0, "ert interval"));
  CHECK(has_note(few, "8 targets, and intervals need 10"));
}

TEST_CASE("pairs are told by running times, budgets by shares", "[cost]") {
  const std::vector<Table> tables = cost_tables(twenty_targets());
  const Table& pairs = named(tables, "statistics-cost-pairs");
  CHECK(readable(cell_at(pairs, 0, "spends less")) == "A");
  CHECK(number_at(pairs, 0, "ert ratio") == Approx(195 / 5071.25));  // 5 of 20 spend 20000, the others half of A's
  CHECK(is_empty(pairs, 0, "remark"));
  const Table& anytime = named(tables, "statistics-cost-anytime");
  CHECK(anytime.rows.size() == 8);
  CHECK(has_note(anytime, "Ahead at 1 %: "));
  CHECK(has_note(anytime, "The budget is 20000 evaluations, those of the longest solve"));
}
