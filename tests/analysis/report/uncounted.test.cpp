// Evaluations that nobody counted, and solves without an answer.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/report/summary.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

// Three solvers with a tolerance of 1 cm; nobody counts what the last one evaluates, a program.
StudyResults study_without_counts() {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA", "BA", "program"}, .runs = 12, .points = 2});
  for (SolveRecord& solve : solves) {
    if (solve.solver != "program") continue;
    solve.evaluations = 0;
    solve.counted_by = CountedBy::nobody;
    solve.timing = Timing::process;
  }
  StudyResults study = make_study("synthetic", std::move(solves));
  study.facts = facts_of(R"({"stop": {"tolerance_cm": 1}})");
  study.plan.program_times = ProgramTimes::compared;
  return study;
}

bool has(const std::vector<std::string>& notes, const std::string& note) {
  return std::ranges::find(notes, note) != notes.end();
}

}  // namespace

TEST_CASE("where the control is left out of a metric, the others are compared with each other", "[uncounted]") {
  StudyResults study = study_without_counts();
  study.plan.control = "program";
  const JudgedStudy judged(std::move(study));
  CHECK(judged.evidence(Metric::evaluations).plan.control.empty());
  CHECK(judged.evidence(Metric::evaluations).contrasts.size() == 1);
  const auto leader_in = [&](Metric metric) {
    return words_of(leader_sentence(judged, metric, average_estimand(metric)));
  };
  CHECK(leader_in(Metric::evaluations).ends_with(" Not compared: program (nobody counted)."));
  CHECK_FALSE(contains(leader_in(Metric::position_error_cm), "Not compared"));
  CHECK(judged.evidence(Metric::position_error_cm).plan.control == "program");
}

TEST_CASE("evaluations that nobody counted are in no comparison", "[uncounted]") {
  const StudyResults study = study_without_counts();
  const Observations observed = observations(study, Metric::evaluations, results::Estimand::mean);
  CHECK(observed.groups.size() == 2);
  CHECK(observations(study, Metric::position_error_cm, results::Estimand::mean).groups.size() == 3);
  CHECK(samples(study, Metric::evaluations)[2].values.empty());
  CHECK(samples(study, Metric::evaluations)[1].values.size() == 12);
}

TEST_CASE("where nobody counts any evaluations, times are as measured", "[uncounted]") {
  StudyResults study = study_without_counts();
  for (Solve& solve : study.solves.to_change()) {
    solve.evaluations = 0;
    solve.counted_by = CountedBy::nobody;
  }
  CHECK(observations(study, Metric::evaluations, results::Estimand::mean).groups.empty());
  CHECK(seconds_of(at_median_speed(study), study.solves[0]) == study.solves[0].seconds);
}

TEST_CASE("where everybody counts no solver is left out", "[uncounted]") {
  const StudyResults study = make_study("synthetic", synthetic::solves({.runs = 3, .points = 2}));
  const StudyResults compared = compared_in(study, Metric::evaluations);
  CHECK(compared.solvers == study.solvers);
  CHECK(compared.solves.size() == study.solves.size());
  CHECK(left_out(study, Metric::evaluations).empty());
}

TEST_CASE("a solve without an answer reaches no tolerance, and is a column of its own", "[uncounted]") {
  StudyResults study = study_without_counts();
  Solve& failed = study.solves.to_change().back();
  failed.status = Status::timed_out;
  failed.position_error_cm = 0.01;  // where the arm happens to be
  StudyResults before = study_without_counts();
  before.solves.to_change().back().position_error_cm = 0.01;
  const auto solved = [](const StudyResults& of) { return std::get<std::int64_t>(solved_table(of).rows.back()[2]); };
  CHECK(solved(before) == solved(study) + 1);
  const Table table = status_table(study);
  const auto has_column = [&](std::string_view name) {
    return std::ranges::find(table.columns, name) != table.columns.end();
  };
  CHECK(has_column("timed_out"));
  CHECK_FALSE(has_column("crashed"));
  CHECK(has_note(table, "gave no answer"));
}

TEST_CASE("a solver without answers wins by nothing but the error of the arm that stays", "[uncounted]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA", "BA", "program"}, .runs = 12, .points = 2});
  for (SolveRecord& solve : solves) {
    solve.start_rad = solve.answer_rad;
    if (solve.solver != "program") continue;
    solve.status = Status::crashed;
    solve.seconds = solve.cpu_seconds = 1e-6;
    solve.variation_deg = solve.largest_move_deg = 0;
    solve.evaluations = 1;
  }
  const JudgedStudy study(make_study("synthetic", std::move(solves)));
  for (const Metric metric : {Metric::seconds, Metric::variation_deg, Metric::evaluations}) {
    INFO(name_of(metric));
    const Evidence& found = study.evidence(metric, Estimand::mean);
    CHECK(judge(found, "program", "IK-BA").relation == Relation::worse);
    CHECK(judge(found, "BA", "program").relation == Relation::better);
    CHECK(words_of(leader_sentence(study, metric, Estimand::mean)).find("program (") == std::string::npos);
  }
  const Table times = times_table(study);
  CHECK_FALSE(std::isfinite(std::get<double>(times.rows.back()[1])));
  CHECK(has_note(times_table(study), "A solve without an answer counts as the longest"));
}

TEST_CASE("times of a program are ranked with those of built-in solvers only where the plan says so", "[uncounted]") {
  StudyResults study = study_without_counts();
  CHECK(solvers_left_out(study, Metric::seconds).empty());
  CHECK(observations(study, Metric::seconds).groups.size() == 3);
  study.plan.program_times = ProgramTimes::apart;
  CHECK(solvers_left_out(study, Metric::seconds) == std::set<std::string, std::less<>>{"program"});
  CHECK(
      words_of(times_doubts(study)) ==
      "Times of program are not compared, because they have messages and another process in them. analysis.program_times = "
      "\"compared\" compares them all the same.");
  CHECK(observations(study, Metric::seconds).groups.size() == 2);
  CHECK(observations(study, Metric::position_error_cm).groups.size() == 3);
  CHECK(samples(study, Metric::seconds)[2].values.size() == 12);  // tables show them
  const auto is_other = [](std::string_view solver) { return solver != "BA"; };
  CHECK(words_of(timing_doubts(of_solvers(study, is_other)))
            .starts_with("Times are not comparable: those of program have"));
  CHECK(times_are_comparable(of_solvers(study, [](std::string_view solver) { return solver == "program"; })));
}

TEST_CASE("evaluations that a program claims are not held against those that were counted", "[uncounted]") {
  std::vector<SolveRecord> solves =
      synthetic::solves({.solvers = {"IK-BA", "BA", "one", "two"}, .runs = 12, .points = 2});
  for (SolveRecord& solve : solves) {
    if (solve.solver != "one" && solve.solver != "two") continue;
    solve.counted_by = CountedBy::solver;
    solve.evaluations = 1;
  }
  const JudgedStudy study(make_study("synthetic", solves));
  const Observations observed = observations(study, Metric::evaluations);
  CHECK(observed.groups.size() == 2);
  CHECK(has(
      observed.notes,
      "Evaluations of one, two are not compared: these were counted by the solver itself, those of the others by ikbench."));
  CHECK(samples(study, Metric::evaluations)[2].values.size() == 12);
  CHECK(judge(study.evidence(Metric::evaluations), "one", "BA").why == "one is left out of the comparison");
  const auto is_program = [](std::string_view solver) { return solver == "one" || solver == "two"; };
  CHECK(observations(of_solvers(study, is_program), Metric::evaluations).groups.size() == 2);
}

TEST_CASE("one disturbed solver takes no times from the others", "[uncounted]") {
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "PSO") solve.cpu_seconds = solve.seconds / 2;
  }
  const JudgedStudy study(make_study("synthetic", solves));
  CHECK(times_are_comparable(study));
  CHECK(
      words_of(times_doubts(study)) ==
      "Times of PSO are not compared, because 400 of 400 solves took more than 1.1 times their CPU time, so other programs "
      "were running.");
  CHECK(study.evidence(Metric::seconds).groups.size() == 5);
  CHECK(judge(study.evidence(Metric::seconds), "IK-BA", "DE").relation == Relation::better);
}

TEST_CASE("of two solvers the disturbed one is named, and where all are none is", "[uncounted]") {
  const auto doubt_where = [](bool is_of_all) {
    std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA", "PSO"}, .runs = 12, .points = 2});
    for (SolveRecord& solve : solves) {
      if (is_of_all || solve.solver == "PSO") solve.cpu_seconds = solve.seconds / 2;
    }
    return timing_doubts(make_study("synthetic", std::move(solves))).front();
  };
  const Doubt of_one = doubt_where(false), of_all = doubt_where(true);
  CHECK(title_of(of_one) == "Times of PSO are not comparable");
  CHECK(words_of(of_one).starts_with("Times are not comparable: of PSO, 24 of 24 solves took"));
  CHECK(title_of(of_all) == "Times are not comparable");
  CHECK(words_of(of_all).starts_with("Times are not comparable: 48 of 48 solves took"));
}
