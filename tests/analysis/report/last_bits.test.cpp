// What last bits change: certificates by hand.
#include "analysis/report/last_bits.hpp"

#include <algorithm>

#include "analysis/inference/make_study.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

// Ten solves of three solvers: one that never changes, one whose evaluations differ by `more`, and one that misses its
// target `missed` times.
StudyResults study_of(const std::string& name, int perturbed, int more, int missed) {
  std::vector<SolveRecord> solves;
  for (int run = 1; run <= 10; ++run) {
    for (const char* solver : {"same", "moved", "broken"}) {
      SolveRecord solve{.solver = solver, .run = run};
      solve.position_error_cm = 0.5;
      solve.evaluations = 100 + (solver == std::string("moved") ? more : 0);
      if (solver == std::string("broken") && run <= missed) {
        solve.status = Status::tolerance_missed;
        solve.position_error_cm = 2;
      }
      solves.push_back(solve);
    }
  }
  StudyResults study = make_study(name, std::move(solves));
  study.facts.perturbed = perturbed;
  return study;
}

std::string certificate_of(const Table& table, const std::string& solver, const std::string& metric) {
  for (const std::vector<Cell>& row : table.rows) {
    if (readable(row[0]) == solver && readable(row[1]) == metric) return readable(row[2]);
  }
  return "none";
}

}  // namespace

TEST_CASE("errors below rounding are the same to last bits", "[last_bits]") {
  StudyResults study = study_of("mine", 0, 0, 0), copy = study_of("mine-perturbed-1", 1, 0, 0);
  for (Solve& solve : study.solves.to_change()) solve.position_error_cm = 2e-14;
  for (Solve& solve : copy.solves.to_change()) solve.position_error_cm = 3e-14;
  CHECK(certificate_of(last_bits_table(study, {copy}), "same", "position error [cm]") == "exact");
}

TEST_CASE("a solver is exact, stable or chaotic by what its copies show", "[last_bits]") {
  const StudyResults study = study_of("mine", 0, 0, 0);
  const PerturbedCopies copies{study_of("mine-perturbed-1", 1, 0, 0), study_of("mine-perturbed-2", 2, 7, 3)};
  for (const StudyResults& copy : copies) CHECK(is_copy_of(copy, "mine"));
  CHECK_FALSE(is_copy_of(study, "mine"));
  CHECK_FALSE(is_copy_of(copies[0], "other"));
  CHECK(changed_statuses(study, copies, "broken") == 3);
  CHECK(changed_statuses(study, copies, "moved") == 0);
  const Table table = last_bits_table(study, copies);
  CHECK(certificate_of(table, "same", "evaluations") == "exact");
  CHECK(certificate_of(table, "moved", "evaluations") == "stable");
  CHECK(certificate_of(table, "moved", "position error [cm]") == "exact");
  CHECK(certificate_of(table, "broken", "position error [cm]") == "chaotic");
  CHECK(certificate_of(table, "broken", "evaluations") == "exact");
  const auto moved = std::ranges::find_if(table.rows, [](const std::vector<Cell>& row) {
    return readable(row[0]) == "moved" && readable(row[1]) == "evaluations";
  });
  CHECK(std::get<double>((*moved)[3]) == 100);
  CHECK(std::get<double>((*moved)[4]) == 100);
  CHECK(std::get<double>((*moved)[5]) == 107);
  CHECK(
      last_bits_sentence(study, copies) ==
      "Last bits of the targets, changed 2 times. Exact in every metric: same. Stable, with other numbers and the same "
      "statuses: moved. Chaotic: broken (3 of 10 solves). There last bits decide the status of solves, so nobody can "
      "repeat such numbers to the last digit.");
  CHECK(last_bits_sentence(study, {}).empty());
}
