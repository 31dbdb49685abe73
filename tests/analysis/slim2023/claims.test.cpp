// The paper's claims, each judged by the numbers of a study.
#include <algorithm>

#include "analysis/slim2023/paper_claims.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::slim2023;

namespace {

bool contains(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

StudyResults study_of(std::vector<SolveRecord> solves, const std::string& name = "s") {
  StudyResults study = make_study(name, std::move(solves));
  study.published = "slim2023";
  return study;
}

std::vector<Claim> claims_of(StudyResults study, const std::vector<StudyResults>& companions = {}) {
  const JudgedStudy judged(std::move(study));
  const std::vector<JudgedStudy> others(companions.begin(), companions.end());
  return claims({judged, {others.begin(), others.end()}});
}

const Claim& claim_of(const std::vector<Claim>& claims, const std::string& statement) {
  const auto found = std::ranges::find_if(claims, [&](const Claim& c) { return contains(c.statement, statement); });
  REQUIRE(found != claims.end());
  return *found;
}

Verdict verdict_of(const std::vector<Claim>& claims, const std::string& statement) {
  return claim_of(claims, statement).verdict;
}

}  // namespace

TEST_CASE("claims hold, hold in part, are undecided or fail, by the store's numbers", "[report]") {
  const auto as_printed = claims_of(study_of(synthetic::solves({})));
  CHECK(verdict_of(as_printed, "is the most accurate") == Verdict::holds);
  CHECK(verdict_of(as_printed, "Accuracy: IK-BA < K-ABC < DE < MO-PSO < PSO < BA") == Verdict::in_part);  // as in print
  CHECK(verdict_of(as_printed, "less than MO-PSO") == Verdict::undecided);  // printed 87.2 and 90.0 deg
  CHECK(verdict_of(as_printed, "less than the other solvers") == Verdict::holds);
  CHECK(verdict_of(as_printed, "Computing time: PSO < IK-BA") == Verdict::holds);
  CHECK(verdict_of(as_printed, "The solvers differ") == Verdict::holds);
  CHECK(verdict_of(as_printed, "inside the joint limits") == Verdict::holds);
  StudyResults by_point = study_of(synthetic::solves({}));
  by_point.plan.unit = Unit::point;
  CHECK(verdict_of(claims_of(by_point), "less than the other") == Verdict::undecided);

  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "IK-BA") {
      solve.position_error_cm *= 1000;
      solve.variation_deg *= 2;
      solve.limit_violation_deg = 1;
    }
    solve.timing = Timing::parallel;
  }
  const auto otherwise = claims_of(study_of(solves));
  CHECK(verdict_of(otherwise, "is the most accurate") == Verdict::fails);
  CHECK(verdict_of(otherwise, "less than MO-PSO") == Verdict::fails);
  CHECK(verdict_of(otherwise, "Computing time") == Verdict::undecided);
  CHECK(verdict_of(otherwise, "inside the joint limits") == Verdict::fails);

  solves[0].position_error_cm = not_defined;  // an answer of IK-BA that is none
  CHECK(verdict_of(claims_of(study_of(solves)), "is the most accurate") == Verdict::fails);
  CHECK(claims_of(make_study("unpublished", synthetic::solves({}))).empty());
}

TEST_CASE("where all solvers are the same to the bit, no printed ranking can be decided", "[report]") {
  std::vector<SolveRecord> solves = synthetic::solves({.runs = 3});
  for (SolveRecord& solve : solves) {
    solve.position_error_cm = solve.claimed_error_cm = 1 + 0.1 * solve.run;
    solve.variation_deg = 10 + solve.run;
    solve.seconds = solve.cpu_seconds = 0.001 * solve.run;
  }
  const auto tied = claims_of(study_of(solves));
  const Claim& accuracy = claim_of(tied, "Accuracy: IK-BA < K-ABC < DE < MO-PSO < PSO < BA");
  CHECK(accuracy.verdict == Verdict::undecided);
  CHECK(contains(accuracy.evidence, "0 of 15 pairs rank as in the paper, 15 are tied; first is IK-BA, "));
  CHECK(contains(accuracy.evidence, " (tied)."));
  CHECK(!contains(accuracy.evidence, "as printed"));
  CHECK(verdict_of(tied, "Computing time") == Verdict::undecided);
  CHECK(verdict_of(tied, "is the most accurate") == Verdict::undecided);
  CHECK(verdict_of(tied, "less than the other solvers") == Verdict::undecided);
  CHECK(verdict_of(tied, "The solvers differ") == Verdict::fails);
}

TEST_CASE("claims are judged on the printed numbers too, by Games and Howell's test", "[report]") {
  const auto all = claims_of(study_of(synthetic::solves({})));
  const auto printed = [&](const char* statement) { return claim_of(all, statement).printed; };
  CHECK(printed("is the most accurate") == Verdict::holds);
  CHECK(printed("Accuracy: IK-BA") == Verdict::in_part);     // MO-PSO, PSO and DE cannot be told apart
  CHECK(printed("less than MO-PSO") == Verdict::undecided);  // 87.1916 and 89.9602 deg, std 7.8 and 25.7: p = 0.997
  CHECK(contains(claim_of(all, "less than MO-PSO").evidence, "MO-PSO 90 (p = 0.997)"));
  CHECK(printed("less than the other solvers") == Verdict::holds);
  CHECK(printed("Computing time: PSO < IK-BA") == Verdict::in_part);  // PSO and IK-BA differ, DE and K-ABC do not
  CHECK(printed("The solvers differ") == Verdict::holds);
  CHECK(!printed("inside the joint limits"));
  CHECK(tally(all) == "Of 7 claims, 5 hold, 1 holds in part and 1 is undecided. By the printed numbers, 3 of 6 hold.");
}

TEST_CASE("a solver that is the most accurate by its mean alone is so in part, where the plan asks for more than means",
          "[report]") {
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "PSO" && solve.point != solve.run) solve.position_error_cm *= 1e-6;  // lost once in a run
  }
  StudyResults study = study_of(solves);
  const Claim claim = claim_of(claims_of(study), "is the most accurate");
  CHECK(claim.verdict == Verdict::in_part);
  CHECK(claim.printed == Verdict::holds);
  CHECK(contains(claim.evidence, "against each other solver); by typical error PSO is better. Printed: "));
  CHECK(contains(claim.evidence, " Smallest typical error: PSO ("));
  CHECK(contains(claim.evidence, " Most often within 0.01 cm: IK-BA (100 %; next PSO 95 %, p = "));
  study.plan.estimands = {Estimand::mean};
  CHECK(verdict_of(claims_of(study), "is the most accurate") == Verdict::holds);
}

TEST_CASE("an order that most pairs keep holds in part", "[report]") {
  std::vector<SolveRecord> solves = synthetic::solves({});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "PSO") solve.seconds *= 1.25;  // from the first place to the second
  }
  CHECK(verdict_of(claims_of(study_of(solves)), "Computing time") == Verdict::in_part);
  for (SolveRecord& solve : solves) solve.seconds = solve.cpu_seconds = 0.02 - solve.seconds;
  CHECK(verdict_of(claims_of(study_of(solves)), "Computing time") == Verdict::fails);
}

TEST_CASE("companions say what is left with limits enforced and against a classical solver", "[report]") {
  const StudyResults study = study_of(synthetic::solves({}), "s");
  StudyResults limits = study_of(synthetic::solves({}), "s-limits");
  limits.definition = R"({"limits": "enforced"})";
  limits.solves[0].status = Status::refused;  // of IK-BA
  StudyResults context = make_study("s-context", synthetic::solves({.solvers = {"DLS"}}));
  for (SolveRecord& solve : context.solves) {
    solve.position_error_cm *= 1e-4;
    solve.variation_deg /= 2;
    solve.evaluations = 11;
  }
  auto all = claims_of(study, {limits, context});
  CHECK(verdict_of(all, "enforced joint limits, IK-BA is still the most accurate") == Verdict::holds);
  CHECK(contains(claim_of(all, "enforced").evidence, "IK-BA 1 of 400, BA 0 of 400"));
  CHECK(verdict_of(all, "classical") == Verdict::fails);
  CHECK(contains(claim_of(all, "classical").evidence, "vs 11 evaluations"));

  for (SolveRecord& solve : context.solves) solve.evaluations = 20000;
  for (SolveRecord& solve : limits.solves) solve.position_error_cm *= solve.solver == "IK-BA" ? 1000 : 1;
  all = claims_of(study, {limits, context});
  CHECK(verdict_of(all, "enforced") == Verdict::fails);
  CHECK(verdict_of(all, "classical") == Verdict::in_part);
  CHECK(claims_of(study).size() + 2 == all.size());
}

TEST_CASE("a circle is led to rounding error where its errors are of the order of rounding", "[report]") {
  StudyResults circle = study_of(synthetic::solves({.solvers = {"IK-BA", "BA"}, .runs = 1}));
  circle.definition = R"({"path": {"kind": "circle"}})";
  const auto verdict = [&](double first, double second) {
    for (SolveRecord& solve : circle.solves) solve.position_error_cm = solve.solver == "IK-BA" ? first : second;
    return verdict_of(claims_of(circle), "Dobot");
  };
  // The targets are 60 to 100 cm away, so that rounding is some 2e-14 cm.
  CHECK(verdict(3e-14, 1) == Verdict::holds);  // the second solver is of no account
  CHECK(verdict(3e-12, 0) == Verdict::fails);
}

TEST_CASE("real time is judged by the slowest target, and only where all are reached it holds", "[report]") {
  StudyResults study = study_of(synthetic::solves({.runs = 2}));
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"12 bats"}, .runs = 1});
  const auto verdict = [&] {
    StudyResults companion = study_of(solves, "s-time");
    companion.definition = R"({"stop": {"tolerance_cm": 0.1}})";
    return verdict_of(claims_of(study, {companion}), "real time");
  };
  CHECK(verdict() == Verdict::holds);
  solves[3].position_error_cm = 0.2;
  CHECK(verdict() == Verdict::in_part);
  solves[4].seconds = 0.06;  // 60 ms, but for as many evaluations as the others: the program was interrupted
  CHECK(verdict() == Verdict::in_part);
  solves[4].cpu_seconds = 0.06;
  solves[4].evaluations *= 25;
  CHECK(verdict() == Verdict::fails);
}
