// What a comparison is unfair in: budgets of evaluations, and a single target.
#include <algorithm>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/make_study.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;

namespace {

// Four solves of each of two solvers; B makes so many evaluations, A a hundred.
StudyResults study_of(int evaluations_of_b, StopReason stop_reason_of_b = StopReason::iterations,
                      CountedBy counted_by_b = CountedBy::suite) {
  std::vector<SolveRecord> solves;
  for (int i = 1; i <= 4; ++i) {
    solves.push_back({.solver = "A", .run = i, .point = 1, .evaluations = 100});
    solves.push_back({.solver = "B",
                      .run = i,
                      .point = 1,
                      .evaluations = evaluations_of_b,
                      .stop_reason = stop_reason_of_b,
                      .counted_by = counted_by_b});
  }
  StudyResults study = make_study("fair", std::move(solves));
  study.facts.path = "helix";
  study.points = 20;
  return study;
}

}  // namespace

TEST_CASE("equal iterations that are not equal evaluations are told with both numbers", "[fairness]") {
  CHECK(
      words_of(fairness_doubts(study_of(1400))) ==
      "Equal iterations are not equal evaluations: a solve of A makes 100, one of B 1400. stop.evaluations would give "
      "all solvers the same budget.");
  CHECK(words_of(fairness_doubts(study_of(25))).find("a solve of B makes 25, one of A 100") != std::string::npos);
}

TEST_CASE("budgets are alike below a factor of two, where something else ends solves, or nobody counted",
          "[fairness]") {
  CHECK(fairness_doubts(study_of(199)).empty());
  CHECK(fairness_doubts(study_of(1400, StopReason::tolerance)).empty());
  CHECK(fairness_doubts(study_of(1400, StopReason::iterations, CountedBy::solver)).empty());
  StudyResults limited = study_of(1400);
  limited.facts.stop.evaluations = 2000;
  CHECK(fairness_doubts(limited).empty());
}

TEST_CASE("one target for all solves is told, and a new one in each run is not one", "[fairness]") {
  StudyResults study = study_of(100);
  study.points = 1;
  CHECK(words_of(fairness_doubts(study)) ==
        "All solves have the same target, so nothing is known of others: another solver may be better there.");
  study.facts.draws_targets = true;
  CHECK(fairness_doubts(study).empty());
}

TEST_CASE("a comparison of populations alone lacks a gradient method, unless a companion has one", "[fairness]") {
  const auto with = [](int iterations_of_b) {
    StudyResults study = study_of(100);
    for (Solve& solve : study.solves.to_change()) solve.iterations = 10;
    for (Solve& solve : study.solves.to_change())
      if (solve.solver == 1) solve.iterations = static_cast<std::uint32_t>(iterations_of_b);
    return study;
  };
  const StudyResults populations = with(5);  // 10 and 20 evaluations an iteration
  CHECK(
      words_of(fairness_doubts(populations)) ==
      "Every solver evaluates many candidates in an iteration (10 or more). A method that follows the gradient may solve "
      "the same targets with far fewer evaluations: add solver = \"damped_least_squares\".");
  CHECK(fairness_doubts(with(50)).empty());  // B evaluates two
  const JudgedStudy companion(with(50)), other(populations);
  CHECK(fairness_doubts(populations, {companion}).empty());
  CHECK_FALSE(fairness_doubts(populations, {other}).empty());
  StudyResults of_library = populations;
  of_library.external = {"B"};
  CHECK(fairness_doubts(of_library).empty());
  StudyResults uncounted = populations;
  for (Solve& solve : uncounted.solves.to_change()) solve.counted_by = CountedBy::solver;
  CHECK(fairness_doubts(uncounted).empty());
}
