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

// Eight solves of one solver in two runs, each of another target, of which five come to the tolerance. By hand: ERT
// 4320 / 5 = 864, SP1 264 / 0.625 = 422.4, Kaplan-Meier 0.875 0.75 0.625 0.5 0.375 at 80 120 220 340 560, restricted
// mean to 1000 80 + 0.875 40 + 0.75 100 + 0.625 120 + 0.5 220 + 0.375 440 = 540.
std::vector<SolveRecord> eight_records() {
  const std::vector<std::int64_t> evaluations{120, 340, 80, 1000, 1000, 560, 1000, 220};
  const std::vector<double> error_cm{0.05, 0.1, 0, 0.2, 3, 0.01, not_a_number, 0.09};
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"A"}, .runs = 2, .points = 4});
  for (std::size_t i = 0; i < solves.size(); ++i) {
    solves[i].evaluations = evaluations[i];
    solves[i].position_error_cm = error_cm[i];
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

std::optional<Figure> survival_figure_of(const StudyResults& study) {
  for (Figure& figure : convergence_figures(study)) {
    if (figure.name == "statistics-survival-evaluations") return std::move(figure);
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("what a tolerance costs, by running times and the survival curve", "[cost]") {
  const Table table = evaluations_table(eight_solves(independent));
  CHECK(number_at(table, 0, "solves") == 8);
  CHECK(number_at(table, 0, "reached") == 5);
  CHECK(number_at(table, 0, "ert") == Approx(864));
  CHECK(number_at(table, 0, "sp1") == Approx(422.4));
  CHECK(number_at(table, 0, "median") == 340);  // where the curve comes to 0.5
  CHECK(number_at(table, 0, "restricted_mean") == Approx(540));
  CHECK(has_note(table, "up to 1000 evaluations"));
  // Wilson's formula for 5 of 8 with z = 1.959964.
  CHECK(number_at(table, 0, "share_low") == Approx(0.3057423946).epsilon(1e-8));
  CHECK(number_at(table, 0, "share_high") == Approx(0.8631557142).epsilon(1e-8));
}

TEST_CASE("dependent solves have neither an interval nor a test, runs do", "[cost]") {
  StudyResults study = eight_solves(chained);
  for (Solve& solve : study.solves.to_change()) {
    if (solve.run == 1) solve.position_error_cm = 0.1;
  }
  const Table table = evaluations_table(study);
  CHECK(is_empty(table, 0, "share_low"));
  CHECK(is_empty(table, 0, "share_high"));
  CHECK(number_at(table, 0, "runs") == 2);
  CHECK(number_at(table, 0, "runs_reached") == 1);
  // Wilson's formula for 1 of 2.
  CHECK(number_at(table, 0, "runs_low") == Approx(0.0945312057).epsilon(1e-8));
  CHECK(number_at(table, 0, "runs_high") == Approx(0.9054687943).epsilon(1e-8));
  CHECK(has_note(table, "depend on each other"));
  const Table of_independent = evaluations_table(eight_solves(independent));
  CHECK(has_note(of_independent, "Solves are independent"));
  CHECK(is_empty(of_independent, 0, "runs"));
}

TEST_CASE("where runs repeat their targets, a target is one trial and there is no test that counts solves", "[cost]") {
  // A deterministic solver on a path of four targets: twenty runs alike, of which every one reaches three; and one that
  // needs twice as much.
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"once", "twice"}, .runs = 20, .points = 4});
  for (SolveRecord& solve : solves) {
    solve.evaluations = 100 * solve.point * (solve.solver == "once" ? 1 : 2);
    solve.position_error_cm = solve.point < 4 ? 0 : 1;
  }
  StudyResults study = make_study("path", std::move(solves));
  study.facts = facts_of(R"({"stop": {"tolerance_cm": 0.1}, "path": {"kind": "helix"}, "start": "initial"})");
  const Table table = evaluations_table(study);
  CHECK(number_at(table, 0, "solves") == 80);
  CHECK(number_at(table, 0, "reached") == 60);
  // Wilson's formula for 3 of 4 with z = 1.959964, as of a single run; of 60 in 80 it would be 0.645 to 0.832.
  CHECK(number_at(table, 0, "share_low") == Approx(0.3006418426).epsilon(1e-8));
  CHECK(number_at(table, 0, "share_high") == Approx(0.9544127392).epsilon(1e-8));
  CHECK(!has_note(table, "chi-squared"));
  CHECK(has_note(table, "targets repeat, so one trial is a target"));
  CHECK(!has_note(table, "Solves are independent"));
  // Half of the runs come to the fourth: the mean of the shares is 3.5 of 4.
  for (Solve& solve : study.solves.to_change()) solve.position_error_cm = solve.point < 4 || solve.run % 2 == 0 ? 0 : 1;
  const double p = number_at(evaluations_table(study), 0, "share_low");
  CHECK(0.875 - p == Approx(1.959963984540054 * std::sqrt(p * (1 - p) / 4)));
}

TEST_CASE("targets of the same place and another rotation, or that are no numbers, are told apart", "[cost]") {
  std::vector<SolveRecord> solves = eight_records();
  for (SolveRecord& solve : solves) solve.target_position_m = {0.5, not_a_number, 0};
  CHECK(has_note(evaluations_table(study_of(solves, independent)), "targets repeat"));
  for (std::size_t i = 0; i < solves.size(); ++i) solves[i].target_rotation = {static_cast<double>(i)};
  CHECK(has_note(evaluations_table(study_of(solves, independent)), "Solves are independent"));
}

TEST_CASE("a run with missing points is not counted among those that came to the tolerance", "[cost]") {
  StudyResults study = eight_solves(chained);
  for (Solve& solve : study.solves.to_change()) solve.position_error_cm = 0;
  study.solves.to_change().pop_back();
  CHECK(number_at(evaluations_table(study), 0, "runs") == 1);
}

TEST_CASE("the error of the verifier may be above the tolerance by its rounding, not by more", "[cost]") {
  StudyResults study = eight_solves(R"({"stop": {"tolerance_cm": 0.1}})");
  study.solves.to_change().front().evaluations = 7;
  study.solves.to_change().front().position_error_cm = 0.1 + 5e-8;
  CHECK(censored_costs(study, Cost::evaluations).front().front().reached);
  CHECK(censored_costs(study, Cost::evaluations).front().front().spent == 7);
  study.solves.to_change().front().position_error_cm = 0.1 + 2e-7;
  CHECK(!censored_costs(study, Cost::evaluations).front().front().reached);
}

TEST_CASE("restricted means of all solvers go to the same cost, where every curve is known", "[cost]") {
  std::vector<SolveRecord> solves = eight_records();
  for (SolveRecord solve : eight_records()) {  // given up earlier
    solve.solver = "B";
    solve.series = "series-b";
    solve.evaluations = 400;
    solve.position_error_cm = 1;
    solves.push_back(solve);
  }
  StudyResults both = make_study("both", std::move(solves));
  both.facts = facts_of(independent);
  const Table table = evaluations_table(both);
  CHECK(has_note(table, "up to 400 evaluations"));
  CHECK(number_at(table, 1, "restricted_mean") == 400);  // nobody reached it
  // By hand: 80 + 0.875 40 + 0.75 100 + 0.625 120 + 0.5 60.
  CHECK(number_at(table, 0, "restricted_mean") == Approx(295));
  CHECK(std::isnan(number_at(table, 1, "ert")));
  CHECK(std::isnan(number_at(table, 1, "median")));
  CHECK(has_note(table, "Not defined for B"));
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
  CHECK(!survival_figure_of(eight_solves("")));
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

TEST_CASE("the survival curve falls from 1 where solves come to the tolerance, and ends with the longest", "[cost]") {
  const std::optional<Figure> figure = survival_figure_of(eight_solves(independent));
  REQUIRE(figure);
  std::istringstream lines(figure->data);
  std::vector<std::pair<double, double>> corners;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    double at = 0, share = 0;
    if (numbers >> at >> share) corners.emplace_back(at, share);
  }
  REQUIRE(corners.size() == 12);
  CHECK(corners.front().second == 1);
  CHECK(corners[1] == std::pair(80.0, 1.0));
  CHECK(corners[2] == std::pair(80.0, 0.875));
  CHECK(corners[10].first == 560);
  CHECK(corners[10].second == Approx(0.375));
  CHECK(corners[11].first == 1000);
  CHECK(corners[11].second == Approx(0.375));
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

TEST_CASE("pairs are told by running times, not by how often one is ahead", "[cost]") {
  const std::vector<Table> tables = cost_tables(twenty_targets());
  const Table& pairs = named(tables, "statistics-cost-pairs");
  CHECK(readable(cell_at(pairs, 0, "spends less")) == "A");
  CHECK(number_at(pairs, 0, "ert ratio") == Approx(195 / 5071.25));  // 5 of 20 spend 20000, the others half of A's
  CHECK(number_at(pairs, 0, "probability of improvement") == 0.25);
  const Table& anytime = named(tables, "statistics-cost-anytime");
  CHECK(anytime.rows.size() == 10);
  CHECK(has_note(anytime, "Ahead at 1 %: "));
  CHECK(has_note(anytime, "The budget is 20000 evaluations, those of the longest solve"));
}
