#include <cmath>

#include "analysis/inference/make_study.hpp"
#include "analysis/report/study_tables.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

struct Given {
  std::string solver;
  double error_cm;
  double variation_deg;
  Status status = Status::ok;
};

StudyResults limited_study(const std::string& name, const char* limits, const std::vector<Given>& answers) {
  std::vector<SolveRecord> solves;
  for (const Given& answer : answers) {
    SolveRecord solve;
    solve.solver = answer.solver;
    solve.position_error_cm = answer.error_cm;
    solve.variation_deg = answer.variation_deg;
    solve.status = answer.status;
    if (answer.status == Status::limit_violated) solve.limit_violation_deg = 3;
    for (const SolveRecord& before : solves) {
      if (before.solver == answer.solver) solve.run = before.run + 1;
    }
    solves.push_back(solve);
  }
  const std::string definition =
      std::string(R"({"points": 1, "analysis": {"test": "tamhane"}, "limits": ")") + limits + "\"}";
  return make_study(StudyEntry{.name = name, .definition = definition, .series = {}}, solves);
}

// Means by hand: recorded IK-BA 2, DE 4; enforced IK-BA 11 (1 without the refused answer), DE 3.
std::optional<Table> limits_of(const std::vector<StudyResults>& studies) {
  const std::vector<JudgedStudy> judged(studies.begin(), studies.end());
  return limits_table({judged.begin(), judged.end()});
}

const StudyResults recorded = limited_study("free", "recorded",
                                            {{"IK-BA", 1, 40, Status::limit_violated},
                                             {"IK-BA", 3, 60},
                                             {"DE", 4, 300},
                                             {"DE", 4, 300, Status::limit_violated},
                                             {"only here", 9, 9}});
const StudyResults enforced = limited_study(
    "held", "enforced",
    {{"IK-BA", 21, 0, Status::refused}, {"IK-BA", 1, 80}, {"DE", 3, 310}, {"DE", 3, 290}, {"only there", 1, 1}});

}  // namespace

TEST_CASE("the limits table sets a study beside the one that enforces the limits", "[limits]") {
  const Table table = *limits_of({recorded, enforced});
  CHECK(table.name == "limits");
  REQUIRE(table.rows.size() == 4);  // solvers of both, first as recorded
  CHECK(number_at(table, 0, "mean_position_error_cm") == 2);
  CHECK(number_at(table, 0, "mean_variation_deg") == 50);
  CHECK(number_at(table, 0, "outside_limits") == 1);
  CHECK(number_at(table, 0, "limit_violated") == 1);
  CHECK(number_at(table, 2, "mean_position_error_cm") == 11);
  CHECK(number_at(table, 2, "mean_accepted_error_cm") == 1);
  CHECK(number_at(table, 2, "mean_variation_deg") == 40);
  CHECK(number_at(table, 2, "mean_accepted_variation_deg") == 80);
  CHECK(number_at(table, 2, "refused") == 1);
  CHECK(has_note(table, "A refused answer leaves the arm where it was"));
}

TEST_CASE("it is said who is better with and without the limits", "[limits]") {
  const Table table = *limits_of({recorded, enforced});
  CHECK(has_note(table, "recorded: Smallest mean error (large errors dominate): IK-BA (2 cm) against DE (4 cm)"));
  CHECK(has_note(table, "enforced: Smallest mean error (large errors dominate): only there"));
}

TEST_CASE("the reported study may be either of the two", "[limits]") {
  const Table table = *limits_of({enforced, recorded});
  CHECK(std::get<std::string>(cell_at(table, 0, "study")) == "free");
  CHECK(std::get<std::string>(cell_at(table, 2, "limits")) == "enforced");
}

TEST_CASE("without a counterpart there is no limits table", "[limits]") {
  CHECK(!limits_table({}));
  CHECK(!limits_of({recorded}));
  CHECK(!limits_of({enforced, enforced}));
  CHECK(!limits_of({recorded, limited_study("s", "enforced", {{"another", 1, 1}})}));
  CHECK(!limits_of({recorded, limited_study("s", "what", {{"IK-BA", 1, 1}})}));
}

TEST_CASE("answers that are not finite, refused throughout or not there have no mean", "[limits]") {
  const Table table =
      *limits_of({recorded, limited_study("s", "enforced",
                                          {{"IK-BA", NAN, 1, Status::not_finite}, {"DE", 7, 0, Status::refused}})});
  CHECK(!std::isfinite(number_at(table, 2, "mean_position_error_cm")));
  CHECK(!std::isfinite(number_at(table, 3, "mean_accepted_error_cm")));
}
