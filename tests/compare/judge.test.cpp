#include "analysis/compare/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/catch.hpp"
#include "tests/compare/studies.hpp"

using namespace ikbench::compare;

namespace {

const Judged& metric(const JudgedStudy& of, std::string_view slug) {
  const auto found = std::ranges::find(of.metrics, slug, [](const Judged& each) { return each.observations.metric; });
  REQUIRE(found != of.metrics.end());
  return *found;
}

std::string slugs(const JudgedStudy& of) {
  std::string all;
  for (const Judged& each : of.metrics) all += each.observations.metric + " ";
  return all;
}

bool has_doubt(const std::vector<Doubt>& doubts, DoubtKind kind) {
  return std::ranges::find(doubts, kind, &Doubt::kind) != doubts.end();
}

}  // namespace

TEST_CASE("A report has the metrics that a study has, and is decided by the plan's, solved or the error") {
  const auto as_made = [](SolveRecord&) {};
  const JudgedStudy of = judge(study({}, as_made));
  CHECK(slugs(of) == "error variation time evaluations ");
  CHECK(of.deciding == 0);
  const JudgedStudy with = judge(study({.tolerance_cm = 1}, as_made));
  CHECK(slugs(with) == "solved variation time evaluations ");
  CHECK(with.deciding == 0);
  const JudgedStudy by_error =
      judge(study({.tolerance_cm = 1, .rest = R"(, "analysis": {"metric": "position_error_cm"})"}, as_made));
  CHECK(slugs(by_error) == "solved error variation time evaluations ");
  const JudgedStudy planned = judge(study({.rest = R"(, "analysis": {"metric": "iterations"})"}, as_made));
  CHECK(slugs(planned) == "error variation time evaluations iterations ");
  CHECK(planned.deciding == 4);
  CHECK_THROWS_AS(judge(study({.rest = R"(, "analysis": {"metric": "beauty"})"}, as_made)), std::invalid_argument);
}

TEST_CASE("A better solver is named, and its findings are those of the table") {
  const JudgedStudy of = judge(study({.runs = 8}, [](SolveRecord& solve) {
    solve.position_error_cm = (solve.solver == "A" ? 1 : 10) + 0.01 * solve.run;
  }));
  const Judged& error = metric(of, "error");
  CHECK(error.headline.best == std::vector<std::string>{"A"});
  REQUIRE(error.findings.size() == 1);
  CHECK(error.findings.front().verdict == Verdict::better);
  CHECK(error.described.front().n == 8);
  CHECK(error.anova->p < 1e-6);
  CHECK(error.kruskal_wallis);
  CHECK(of.doubts.empty());
}

TEST_CASE("The plan's test, level, margin and control reach the comparison") {
  const auto errors = [](SolveRecord& solve) {
    solve.position_error_cm = (solve.solver == "A" ? 1 : 1.5) + 0.01 * solve.run;
  };
  const auto judged = [&](const std::string& plan) {
    return metric(judge(study({.runs = 8, .rest = R"(, "analysis": )" + plan}, errors, {"A", "B", "C"})), "error");
  };
  CHECK(judged(R"({"test": "means"})").findings.front().test == "Welch's t");
  CHECK(judged(R"({"control": "B"})").findings.size() == 2);
  CHECK(judged(R"({"significance": 0.0001})").findings.front().why == Why::too_few);
  CHECK_FALSE(judged(R"({})").findings.front().is_within_margin);
  CHECK(judged(R"({"margin_cm": 0.6})").findings.front().is_within_margin);
  CHECK(judged(R"({"margin_cm": 0.6})").findings.back().verdict == Verdict::same);
}

TEST_CASE("A solver that fails on 3 of 20 targets stays in the error's table, described and not tested") {
  const JudgedStudy of = judge(study({.start = "middle", .targets = "drawn"}, [](SolveRecord& solve) {
    if (solve.solver != "A" || solve.run != 1 || solve.point > 3) return;
    solve.status = Status::not_finite;
    solve.position_error_cm = std::numeric_limits<double>::quiet_NaN();
  }));
  const Judged& error = metric(of, "error");
  CHECK(error.described.front().n == 17);
  CHECK(error.observations.groups.front().lost == 3);
  CHECK(error.findings.front().verdict == Verdict::not_tested);
  CHECK(error.findings.front().why == Why::lost);
  CHECK(has_doubt(of.doubts, DoubtKind::without_answer));
}

TEST_CASE("Where a tolerance is set and both solve all, the share is equal and errors are at most the tolerance") {
  const StudyResults made =
      study({.start = "middle", .targets = "drawn", .runs = 20, .points = 5, .tolerance_cm = 0.01},
            [](SolveRecord& solve) { solve.position_error_cm = solve.solver == "A" ? 0.001 : 0.002; });
  const JudgedStudy of = judge(made);
  const Finding& solved = metric(of, "solved").findings.front();
  CHECK(solved.are_all_equal);
  CHECK(solved.verdict == Verdict::same);
  const Judged error = judge(made, metric_named("position_error_cm"));
  CHECK(error.findings.front().are_all_equal);
  CHECK(error.described.front().median == 0.01);
  CHECK(std::isnan(error.described.front().sd));
}

TEST_CASE("A solver that makes three times the evaluations on what it solves is worse, whatever failures cost") {
  const JudgedStudy of = judge(study(
      {.start = "middle", .targets = "drawn", .runs = 20, .points = 5, .tolerance_cm = 1}, [](SolveRecord& solve) {
        const bool is_failure = (solve.run * 5 + solve.point) % 3 == 0;
        if (is_failure) solve.status = Status::tolerance_missed;
        solve.evaluations = is_failure ? 1000 : (solve.solver == "A" ? 100 : 300) + solve.run;
      }));
  const Judged& evaluations = metric(of, "evaluations");
  CHECK(evaluations.findings.front().verdict == Verdict::better);
  CHECK(evaluations.findings.front().estimate.value() == Approx(110.5 / 310.5).epsilon(0.05));
  CHECK(evaluations.described.front().largest == 120);
  CHECK(metric(of, "solved").findings.front().are_all_equal);
}

TEST_CASE("Costs are compared on the targets that both solvers of a pair solved") {
  // A solves runs 1 to 12, B 9 to 20: four targets in common, which decide nothing.
  const JudgedStudy of = judge(study(
      {.start = "middle", .targets = "drawn", .runs = 20, .points = 1, .tolerance_cm = 1}, [](SolveRecord& solve) {
        const bool is_solved = solve.solver == "A" ? solve.run < 13 : solve.run > 8;
        if (!is_solved) solve.status = Status::tolerance_missed;
        solve.evaluations = solve.solver == "A" ? 100 : 300;
      }));
  const Finding& finding = metric(of, "evaluations").findings.front();
  CHECK(finding.why == Why::too_few);
  CHECK(finding.needed == 6);
  CHECK(finding.estimate.value() == Approx(1.0 / 3));
  CHECK(has_doubt(metric(of, "evaluations").observations.doubts, DoubtKind::too_few));
  // Nothing in common at all.
  const JudgedStudy apart = judge(study(
      {.start = "middle", .targets = "drawn", .runs = 20, .points = 1, .tolerance_cm = 1}, [](SolveRecord& solve) {
        if ((solve.solver == "A") == (solve.run > 10)) solve.status = Status::tolerance_missed;
      }));
  CHECK(metric(apart, "evaluations").findings.front().why == Why::too_few);
  CHECK_FALSE(metric(apart, "evaluations").findings.front().estimate);
}

TEST_CASE("Times that are not comparable are described and not tested") {
  const JudgedStudy of = judge(study({.runs = 10},
                                     [](SolveRecord& solve) {
                                       if (solve.solver == "C") solve.timing = Timing::process;
                                       solve.seconds = solve.cpu_seconds =
                                           (solve.solver == "A" ? 1 : 2) + 0.01 * solve.run;
                                     },
                                     {"A", "B", "C"}));
  const Judged& time = metric(of, "time");
  CHECK(time.described.back().n == 10);
  REQUIRE(time.findings.size() == 3);
  CHECK(time.findings[0].verdict == Verdict::better);
  CHECK(time.findings[1].why == Why::apart);
  CHECK(time.findings[2].verdict == Verdict::not_tested);
  CHECK(has_doubt(time.observations.doubts, DoubtKind::times_not_comparable));
}

TEST_CASE("Too few runs and means that few values decide are told") {
  const JudgedStudy few = judge(study({.runs = 3}, [](SolveRecord& solve) {
    solve.position_error_cm = solve.solver == "A" ? 1 : 2 + 0.01 * solve.run;
  }));
  CHECK(has_doubt(metric(few, "error").observations.doubts, DoubtKind::too_few));
  CHECK(metric(few, "error").observations.doubts.front().count == 3);
  CHECK(metric(few, "error").observations.doubts.front().of == 4);
  const Asked means{.runs = 8, .rest = R"(, "analysis": {"test": "means", "significance": 0.2})"};
  const Judged error = metric(judge(study(means,
                                          [](SolveRecord& solve) {
                                            solve.position_error_cm = solve.solver == "A" ? 0.01 * solve.run
                                                                      : solve.run == 1    ? 9
                                                                                          : 1 + 0.01 * solve.run;
                                          })),
                              "error");
  REQUIRE(has_doubt(error.observations.doubts, DoubtKind::few_decide_mean));
  CHECK(error.observations.doubts.front().who == std::vector<std::string>{"B"});
}

TEST_CASE("The doubt of a solver that repeats itself has the runs of the other") {
  const JudgedStudy of = judge(study({.runs = 5}, [](SolveRecord& solve) {
    if (solve.solver == "A") solve.answer_rad = {0.5 * solve.point};
    solve.position_error_cm = solve.solver == "A" ? 1 : 2 + 0.01 * solve.run;
  }));
  const std::vector<Doubt>& doubts = metric(of, "error").observations.doubts;
  REQUIRE(has_doubt(doubts, DoubtKind::too_few));
  CHECK(doubts.front().who == std::vector<std::string>{"B"});
  CHECK(doubts.front().count == 5);
  CHECK(doubts.front().of == 6);
}

TEST_CASE("Where nothing is solved, no cost is reported") {
  CHECK(slugs(judge(study({.start = "middle", .targets = "drawn", .tolerance_cm = 0.1},
                          [](SolveRecord& solve) { solve.status = Status::tolerance_missed; }))) == "solved ");
}

TEST_CASE("Two identical solvers have no winner in the headline in 95 % of studies") {
  std::mt19937_64 engine(7);
  std::lognormal_distribution<double> error(-3, 1);
  std::bernoulli_distribution solves(0.9);
  const auto winners = [&](const Asked& asked) {
    int count = 0;
    for (int i = 0; i < 400; ++i) {
      const JudgedStudy of = judge(study(asked, [&](SolveRecord& solve) {
        solve.position_error_cm = error(engine);
        if (!solves(engine)) solve.status = Status::tolerance_missed;
      }));
      const Headline& headline = of.metrics[of.deciding].headline;
      count += !headline.best.empty() || !headline.usual.empty();
    }
    return count;
  };
  CHECK(winners({.runs = 10}) <= 30);  // 20 expected at most, plus 2.3 standard errors
  CHECK(winners({.start = "middle", .targets = "drawn", .runs = 10, .points = 2}) <= 30);
  CHECK(winners({.runs = 10, .tolerance_cm = 0.1}) <= 30);
  CHECK(winners({.start = "middle", .targets = "drawn", .runs = 20, .points = 2, .tolerance_cm = 0.1}) <= 30);
}
