#include "analysis/slim2023/paper_tables.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/papers.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/report/table.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::slim2023;

namespace {

StudyResults paper_study(std::vector<SolveRecord> solves, const std::string& name = "synthetic") {
  StudyResults study = make_study(name, std::move(solves));
  study.facts.published = "slim2023";
  return study;
}

bool contains(const std::vector<std::string>& notes, const std::string& words) {
  return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

}  // namespace

TEST_CASE("six solvers of 20 runs have 5 and 114 degrees of freedom, as in the paper", "[paper]") {
  const StudyResults study = paper_study(synthetic::solves({}));
  const AnovaTable table = anova(study, Metric::variation_deg).table;
  CHECK(table.df == 5);
  CHECK(table.df_within == 114);
}

TEST_CASE("means and claims stand side by side by both readings of what is searched", "[paper]") {
  const JudgedStudy wrist(paper_study(synthetic::solves({})));
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) solve.position_error_cm *= solve.solver == "IK-BA" ? 2000 : 1;
  for (SolveRecord& solve : solves) solve.position_error_cm *= solve.solver == "DE" && solve.run > 1 ? 1e-3 : 1;
  const JudgedStudy all_joints(paper_study(std::move(solves), "synthetic-all-joints"));
  const StudyPieces pieces = analysis::paper("slim2023").pieces({wrist, {all_joints}});
  const Table& means = *std::ranges::find(pieces.tables, "table-3-readings", &Table::name);
  REQUIRE(means.rows.size() == 6);
  CHECK(std::get<std::string>(cell_at(means, 0, "printed_error_cm")) == "0.0019");
  CHECK(number_at(means, 0, "wrist_error_cm") ==
        describe(samples(wrist, Metric::position_error_cm).front().values).mean);
  CHECK(number_at(means, 0, "all_joints_error_cm") == Approx(2000 * number_at(means, 0, "wrist_error_cm")));
  CHECK(number_at(means, 0, "all_joints_variation_deg") == number_at(means, 0, "wrist_variation_deg"));
  REQUIRE(means.notes.size() == 2);
  CHECK(means.notes[1].starts_with("A few solves decide the position error of DE by all joints: the median"));

  const Table& claims = *std::ranges::find(pieces.tables, "claims-readings", &Table::name);
  std::vector<std::string> ids;
  for (std::size_t row = 0; row < claims.rows.size(); ++row) {
    ids.push_back(std::get<std::string>(cell_at(claims, row, "id")));
    const auto verdict = [&](const char* reading) { return std::get<std::string>(cell_at(claims, row, reading)); };
    if (ids.back() == "most_accurate") {
      CHECK(verdict("wrist") == "holds");
      CHECK(verdict("all_joints") == "fails");
    }
    if (ids.back() == "solvers_differ") CHECK(verdict("wrist") == "holds");  // two of them, without times
  }
  for (const char* id : {"most_accurate", "accuracy_order", "best_compromise", "inside_limits", "solvers_differ"})
    CHECK(std::ranges::count(ids, id) == 1);
  for (const char* id : {"time_order", "pso_fastest", "elongation_control", "circle", "real_arm"})
    CHECK(std::ranges::count(ids, id) == 0);
}

TEST_CASE("a run with missing points gives no run mean, and is counted", "[study]") {
  std::vector<SolveRecord> solves = synthetic::solves({.runs = 3, .points = 4});
  solves.pop_back();  // the last point of MO-PSO's third run
  const StudyResults study = paper_study(solves);
  const Sample sample = samples(study, Metric::position_error_cm).back();
  CHECK(sample.solver == "MO-PSO");
  CHECK(sample.values.size() == 2);
  CHECK(sample.incomplete_runs == 1);
  const SolverCounts count = counts(study).back();
  CHECK(count.solves == 11);
  CHECK(count.expected == 12);
  CHECK(count.complete_runs == 2);
  CHECK(count.incomplete_runs == 1);
  CHECK(contains(table_3(study).notes, "incomplete"));
}

TEST_CASE("runs, points and the paper come from the study's definition", "[study]") {
  const StudyEntry entry{
      .name = "s",
      .definition = R"({"runs": 20, "path": {"kind": "helix", "points": 20}, "published": "slim2023"})",
      .series = {{"k1", "IK-BA", "ik_ba", "{}"}, {"k2", "BA", "ba", "{}"}}};
  const StudyResults study = make_study(entry, {});
  CHECK(study.runs == 20);
  CHECK(study.points == 20);
  CHECK(study.facts.published == "slim2023");
  CHECK(study.solvers == std::vector<std::string>{"IK-BA", "BA"});
  CHECK(counts(study)[0].expected == 400);
}

TEST_CASE("a solve that is there twice or is not numbered from 1 is refused", "[study]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"BA"}, .runs = 1, .points = 2});
  solves[1].point = 1;
  CHECK_THROWS_WITH(make_study("s", solves), "study 's', solver 'BA': run 1, point 1 appears twice; expected once");
  solves[1].point = 0;
  CHECK_THROWS_AS(make_study("s", solves), std::invalid_argument);
}

TEST_CASE("a study larger than any is refused in a sentence", "[study]") {
  StudyEntry entry{.name = "s", .definition = R"({"runs": 1000001})", .series = {{"k1", "BA", "ba", "{}"}}};
  const auto complaint = [&] {
    try {
      make_study(entry, {});
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(complaint() == "study 's': runs 1000001; expected at most 1000000");
  entry.definition = R"({"runs": 18446744073709551615})";
  CHECK(complaint().ends_with("; expected at most 1000000"));
  entry.definition = R"({"runs": 1, "path": {"points": 100001}})";
  CHECK(complaint() == "study 's': points 100001; expected at most 100000");
  entry.definition = R"({"runs": 100000, "points": 1001})";
  CHECK(complaint() == "study 's' has 100000 runs of 1001 points by 1 solvers; expected at most 100000000 solves");
  entry.definition = R"({"runs": 100000, "points": 1000})";
  CHECK(complaint() == "");

  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"BA"}, .runs = 1, .points = 2});
  solves[1].point = 100'001;
  CHECK_THROWS_WITH(make_study("s", solves),
                    "study 's', solver 'BA': run 1, point 100001; expected runs 1 to 1000000 and points 1 to 100000");
  solves.assign(1001, solves[0]);
  for (std::size_t i = 0; i < solves.size(); ++i) solves[i].solver = std::to_string(i);
  CHECK_THROWS_WITH(make_study("s", solves), "study 's' has more than 1000 solvers; expected no more");
}

TEST_CASE("the printed ANOVA stands beside ours only where both ask the same", "[paper]") {
  StudyResults six = paper_study(synthetic::solves({}));
  const auto printed = [](const StudyResults& study) {
    return claims::comparable_anova(study, printed_table_3(study, Metric::variation_deg), "table-5");
  };
  CHECK(printed(six)->statistic == Approx(388.9396));  // as printed
  six.plan.unit = Unit::point;
  CHECK(!printed(six));
  CHECK(!printed(paper_study(synthetic::solves({.solvers = {"IK-BA", "BA"}}))));
}

TEST_CASE("times taken while other programs were at work are said to be so", "[study]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA"}, .runs = 2});
  for (SolveRecord& solve : solves) solve.cpu_seconds = solve.seconds / 1.05;
  CHECK(timing_doubts(paper_study(solves)).empty());
  for (SolveRecord& solve : solves) solve.cpu_seconds = solve.seconds / 2;
  CHECK(words_of(timing_doubts(paper_study(solves))) ==
        "Times are not comparable: 40 of 40 solves took more than 1.1 times their CPU time, so other programs were "
        "running.");
  for (std::size_t i = 0; i < solves.size(); ++i) {  // a tenth is not yet many, and one is never
    solves[i].cpu_seconds = solves[i].seconds / (i % 10 == 0 ? 50 : 1);
  }
  CHECK(timing_doubts(paper_study(solves)).empty());
  solves[1].cpu_seconds /= 50;
  CHECK(!timing_doubts(paper_study(solves)).empty());
  CHECK(timing_doubts(paper_study({solves[0]})).empty());
}

TEST_CASE("without published numbers ours stand alone", "[paper]") {
  const StudyResults study = make_study("own", synthetic::solves({.solvers = {"IK-BA", "BA"}}));
  for (const auto& row : table_3(study).rows) CHECK(std::holds_alternative<double>(row[2]));
  const Table table = table_3(paper_study(synthetic::solves({.solvers = {"IK-BA", "my own"}})));
  CHECK(std::holds_alternative<OursAndPrinted>(table.rows[0][2]));
  CHECK(std::holds_alternative<double>(table.rows[1][2]));  // a solver that is not in the paper
}

TEST_CASE("an answer that is not finite is never dropped", "[paper]") {
  std::vector<SolveRecord> solves = synthetic::solves({});
  SolveRecord& bad = solves[400];  // BA, run 1, point 1
  REQUIRE(bad.solver == "BA");
  bad.position_error_cm = not_defined;
  bad.status = Status::not_finite;
  const StudyResults study = paper_study(solves);
  const Table table_3_here = table_3(study);
  CHECK(to_markdown(table_3_here).find("| BA | position error \\[cm\\] | not defined (printed 1.6849) |") !=
        std::string::npos);
  CHECK(contains(table_3_here.notes, "1 not finite"));
  const StudyAnova without_ba = anova(study, Metric::position_error_cm);
  CHECK(without_ba.table.df == 4);
  CHECK(contains(without_ba.left_out, "BA (1 of 20 observations not finite)"));
  CHECK(contains(anova_table(study, Metric::position_error_cm).notes, "Left out of the ANOVA: BA"));
}

TEST_CASE("the status table has every solve, every status, and how far answers leave the limits", "[paper]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA"}, .runs = 1, .points = 4});
  solves[0].status = Status::limit_violated;
  solves[0].limit_violation_deg = 12.5;
  solves[1].status = Status::claimed_but_wrong;
  solves[1].limit_violation_deg = 3;
  solves[2].timing = Timing::parallel;
  solves[3].status = Status::refused;
  const Table table = status_table(make_study("s", solves));
  CHECK(
      to_csv(table) ==
      "algorithm,planned,not_solved,ok,tolerance_missed,limit_violated,refused,claimed_but_wrong,not_finite,observations,"
      "outside_limits,worst_outside_deg\n"
      "IK-BA,4,0,1,0,1,1,1,0,1,2,12.5\n");
  CHECK(contains(table.notes, "Times are not comparable: of 4 solves, 1 ran in parallel with others"));
  CHECK(contains(table.notes, "A refused answer leaves the arm where it was"));
  solves[3].status = Status::ok;
  CHECK_FALSE(contains(status_table(make_study("s", solves)).notes, "refused answer leaves"));
}

TEST_CASE("every shape of study has its tables and not one cell of NaN", "[paper]") {
  const synthetic::Shape shape = GENERATE(values<synthetic::Shape>(
      {{.solvers = {"IK-BA"}},
       {.solvers = {"IK-BA", "BA"}},
       {.runs = 1},
       {.points = 1},
       {.solvers = {"IK-BA"}, .runs = 1, .points = 1},
       {.solvers = std::vector<std::string>(), .runs = 1, .points = 1},
       {.solvers = {"s1",  "s2",  "s3",  "s4",  "s5",  "s6",  "s7",  "s8",  "s9",  "s10", "s11", "s12", "s13", "s14",
                    "s15", "s16", "s17", "s18", "s19", "s20", "s21", "s22", "s23", "s24", "s25", "s26", "s27", "s28",
                    "s29", "s30", "s31", "s32", "s33", "s34", "s35", "s36", "s37", "s38", "s39", "s40"},
        .runs = 2,
        .points = 2}}));
  StudyResults study = paper_study(synthetic::solves(shape));
  study.plan.unit = GENERATE(Unit::run, Unit::point);
  for (const Table& table : paper_tables(study)) {
    for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
    const std::string all = to_markdown(table) + to_latex(table) + to_csv(table);
    CHECK(all.find("nan") == std::string::npos);
    CHECK(all.find("inf") == std::string::npos);
  }
}
