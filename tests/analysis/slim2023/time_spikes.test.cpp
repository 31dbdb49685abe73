// Another program that has the processor for a moment changes no verdict on times: whichever solve it met.
#include <fmt/format.h>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/papers.hpp"
#include "analysis/report/summary.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

constexpr double spike = 50;

// Everything that is concluded from the times of a study, without the numbers that it rests on.
std::vector<std::string> verdicts(StudyResults of) {
  const JudgedStudy study(std::move(of));
  std::vector<std::string> all{words_of(timing_doubts(study))};
  const std::string leaders = words_of(leader_sentence(study, Metric::seconds, average_estimand(Metric::seconds)));
  all.push_back(leaders.substr(0, leaders.find('(')));
  const Evidence& found = study.evidence(Metric::seconds);
  for (const std::string& first : study.solvers) {
    for (const std::string& second : study.solvers) {
      if (first == second) continue;
      all.push_back(fmt::format("{} {} {}", first, static_cast<int>(judge(found, first, second).relation), second));
    }
  }
  for (const Claim& claim : analysis::paper("slim2023").claims({study, {}})) {
    all.push_back(fmt::format("{} {}", claim.statement, static_cast<int>(claim.verdict)));
  }
  return all;
}

StudyResults helix(std::vector<SolveRecord> solves) {
  return make_study(
      StudyEntry{.name = "s",
                 .definition = R"({"runs": 20, "points": 20, "published": "slim2023", "path": {"kind": "helix"}})",
                 .series = {}},
      std::move(solves));
}

// Twenty targets that every solver solves once, as in slim2023-time: a single solve is an observation.
std::vector<SolveRecord> timed_solves() {
  std::vector<SolveRecord> all =
      synthetic::solves({.solvers = {"12 bats", "15 bats", "20 bats", "30 bats"}, .runs = 1});
  synthetic::Noise noise;
  for (SolveRecord& solve : all) {
    solve.position_error_cm = 0.05;
    solve.evaluations = 2000 + static_cast<std::int64_t>(1000 * noise.next());
    const double pace = solve.solver == "12 bats" ? 1e-7 : solve.solver == "30 bats" ? 4e-7 : 2e-7;
    solve.seconds = solve.cpu_seconds = pace * static_cast<double>(solve.evaluations);
  }
  return all;
}

StudyResults times_to_tolerance(std::vector<SolveRecord> solves) {
  return make_study(StudyEntry{.name = "s-time",
                               .definition = R"({"runs": 1, "points": 20, "published": "slim2023", "start": "initial",
                                   "path": {"kind": "random"}, "stop": {"tolerance_cm": 0.1}})",
                               .series = {}},
                    std::move(solves));
}

}  // namespace

TEST_CASE("one solve that takes 50 times as long changes no verdict on the times of a study", "[times][slim2023]") {
  const std::vector<SolveRecord> clean = synthetic::solves({});
  const std::vector<std::string> before = verdicts(helix(clean));
  CHECK(before.size() > 40);
  for (std::size_t solver = 0; solver < 6; ++solver) {
    std::vector<SolveRecord> solves = clean;
    SolveRecord& met = solves[400 * solver + 61 * solver];
    met.seconds *= spike;
    CAPTURE(met.solver, met.run, met.point);
    CHECK(verdicts(helix(solves)) == before);
    CHECK(words_of(outlier_doubts(helix(solves)))
              .starts_with("1 of 2400 solves took more than 3 times as long as usual."));
  }
}

TEST_CASE("one solve that takes 50 times as long changes no verdict on times to a tolerance", "[times][slim2023]") {
  const std::vector<SolveRecord> clean = timed_solves();
  const std::vector<std::string> before = verdicts(times_to_tolerance(clean));
  for (std::size_t solver = 0; solver < 4; ++solver) {
    std::vector<SolveRecord> solves = clean;
    SolveRecord& met = solves[20 * solver + 3 * solver];
    met.seconds *= spike;
    CAPTURE(met.solver, met.point);
    CHECK(verdicts(times_to_tolerance(solves)) == before);
  }
}
