// Evaluations that nobody counted, and solves without an answer.
#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "analysis/inference/design.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/cost_tables.hpp"
#include "analysis/report/study_tables.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

// Three solvers with a tolerance of 1 cm; nobody counts what the last one evaluates.
StudyResults study_without_counts() {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA", "BA", "program"}, .runs = 12, .points = 2});
  for (SolveRecord& solve : solves) {
    if (solve.solver != "program") continue;
    solve.evaluations = 0;
    solve.counted_by = CountedBy::nobody;
    solve.timing = Timing::process;
    solve.round_trips = 1;
    solve.transport_seconds = 0.6 * solve.seconds;
  }
  StudyResults study = make_study("synthetic", std::move(solves));
  study.definition = R"({"stop": {"tolerance_cm": 1}})";
  return study;
}

bool has_row(const Table& table, const std::string& solver) {
  return std::ranges::any_of(table.rows, [&](const auto& row) { return std::get<std::string>(row[0]) == solver; });
}

bool has_note(const Table& table, std::string_view words) {
  return std::ranges::any_of(table.notes,
                             [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

}  // namespace

TEST_CASE("evaluations that nobody counted are in no comparison and no table of costs", "[uncounted]") {
  const StudyResults study = study_without_counts();
  const Observations observed = observations(study, Metric::evaluations, results::Estimand::mean);
  CHECK(observed.groups.size() == 2);
  CHECK(observations(study, Metric::position_error_cm, results::Estimand::mean).groups.size() == 3);
  CHECK(samples(study, Metric::evaluations)[2].values.empty());
  CHECK(samples(study, Metric::evaluations)[1].values.size() == 12);

  const std::vector<Table> tables = cost_tables(study);
  CHECK(tables.size() >= 4);
  for (const Table& table : tables) {
    INFO(table.name);
    const bool of_seconds = table.name.find("-seconds") != std::string::npos;
    CHECK(has_note(table, "Nobody counted the evaluations of program.") == !of_seconds);
    if (table.name == "statistics-cost") CHECK_FALSE(has_row(table, "program"));
    if (table.name == "statistics-cost-seconds") CHECK(has_row(table, "program"));
  }
}

TEST_CASE("where everybody counts no solver is left out", "[uncounted]") {
  const StudyResults study = make_study("synthetic", synthetic::solves({.runs = 3, .points = 2}));
  CHECK(counted(study).solvers == study.solvers);
  CHECK(counted(study).solves.size() == study.solves.size());
  CHECK(uncounted_note(study).empty());
}

TEST_CASE("a solve without an answer reaches no tolerance, and is a column of its own", "[uncounted]") {
  StudyResults study = study_without_counts();
  SolveRecord& failed = study.solves.back();
  failed.status = Status::timed_out;
  failed.position_error_cm = 0.01;  // where the arm happens to be
  for (const Table& table : cost_tables(study)) {
    if (table.name == "statistics-cost-seconds") {
      StudyResults before = study_without_counts();
      before.solves.back().position_error_cm = 0.01;
      const auto reached = [](const Table& of) { return std::get<std::int64_t>(of.rows.back()[2]); };
      for (const Table& other : cost_tables(before)) {
        if (other.name == table.name) CHECK(reached(other) == reached(table) + 1);
      }
    }
  }
  const Table table = status_table(study);
  const auto has_column = [&](std::string_view name) {
    return std::ranges::any_of(table.columns, [&](const Column& column) { return column.name == name; });
  };
  CHECK(has_column("timed_out"));
  CHECK_FALSE(has_column("crashed"));
  CHECK(has_column("timing_process"));
  CHECK(has_note(table, "gave no answer"));
}

TEST_CASE("that most of a program's time is transport is said beside its times", "[uncounted]") {
  StudyResults study = study_without_counts();
  CHECK(transport_note(study) ==
        "At least half of the time of program is transport: messages to the program and back.");
  CHECK(times_are_comparable(study));
  for (SolveRecord& solve : study.solves) solve.transport_seconds *= 0.5;
  CHECK(transport_note(study).empty());
}
