// Mean, typical value and reliability of the same solves: by hand, and where each has another winner.
#include "analysis/inference/estimand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "analysis/inference/design.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/summary.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

constexpr Metric position_error = Metric::position_error_cm;
constexpr double never = std::numeric_limits<double>::quiet_NaN();

struct GivenRun {
  std::string solver;
  std::vector<double> errors_cm;  // of its points
};

JudgedStudy judged_runs(const std::vector<GivenRun>& runs, const std::string& more = "") {
  std::vector<SolveRecord> solves;
  std::vector<Series> series;
  std::map<std::string, int> count;
  for (const GivenRun& run : runs) {
    if (++count[run.solver] == 1) series.push_back({.label = run.solver});
    for (std::size_t point = 0; point < run.errors_cm.size(); ++point) {
      SolveRecord solve{.solver = run.solver, .run = count[run.solver], .point = static_cast<int>(point) + 1};
      solve.position_error_cm = run.errors_cm[point];
      solve.seconds = solve.cpu_seconds = 1;
      solves.push_back(solve);
    }
  }
  return JudgedStudy(
      make_study({.name = "s", .definition = R"({"path": {"kind": "helix"})" + more + "}", .series = std::move(series)},
                 std::move(solves)));
}

std::vector<double> values(const StudyResults& study, Estimand estimand) {
  return observations(study, position_error, estimand).groups.at(0).values;
}

// Twenty runs of each: A never fails and is never exact, B is exact or lost, C is near eight times of ten.
std::vector<GivenRun> three_winners() {
  std::vector<GivenRun> runs;
  for (int run = 1; run <= 20; ++run) {
    const double f = 1 + 0.001 * run;
    runs.push_back({"A", std::vector<double>(10, 0.02 * f)});
    runs.push_back({"B", {1e-6 * f, 1e-6 * f, 1e-6 * f, 1e-6 * f, 1e-6 * f, f, f, f, f, f}});
    runs.push_back({"C", {}});
    for (int point = 0; point < 10; ++point) runs.back().errors_cm.push_back(point < 8 ? 0.009 * f : 10 * f);
  }
  return runs;
}

}  // namespace

TEST_CASE("an observation is the mean, the mean of logarithms or the share within a distance", "[estimand]") {
  const JudgedStudy study = judged_runs({{"A", {0.01, 1e-4}}, {"A", {0.1, 1e-9}}, {"A", {0.02, 0.2}}});
  const std::vector<double> means = values(study, Estimand::mean);
  REQUIRE(means.size() == 3);
  CHECK(means[0] == Approx(0.00505));
  CHECK(means[1] == Approx(0.05000005).epsilon(1e-12));  // 1e-9 cm counts as 1e-7, which is rounding
  CHECK(means[2] == Approx(0.11));
  const std::vector<double> typical = values(study, Estimand::typical);
  REQUIRE(typical.size() == 3);
  CHECK(typical[0] == Approx(-3));  // (-2 - 4) / 2
  CHECK(typical[1] == Approx(-4));  // (-1 - 7) / 2: below 1e-7 counts as 1e-7
  CHECK(typical[2] == Approx((std::log10(0.02) + std::log10(0.2)) / 2));
  CHECK(values(study, Estimand::reliability) == std::vector<double>{1, 0.5, 0});  // 0.01 cm is within 0.01 cm
  StudyResults by_point = study;
  by_point.plan.unit = Unit::point;
  CHECK(values(by_point, Estimand::reliability) == std::vector<double>{1, 1, 0, 1, 0, 0});
  const Observations shares = observations(study, position_error, Estimand::reliability);
  CHECK(shares.name == "error-reliability");
  CHECK(shares.quantity == "share of solves within 0.01 cm");
  CHECK(shares.better == Better::larger);
  CHECK(shares.replicate == "the share of a run over its 2 points");
  const Observations logarithms = observations(study, position_error, Estimand::typical);
  CHECK(logarithms.name == "error-typical");
  CHECK(logarithms.quantity == "typical position error [cm]");
  CHECK(logarithms.replicate == "the geometric mean of a run over its 2 points");
  CHECK(logarithms.counting.front() == "A value below 1e-07 cm counts as 1e-07 cm, because below that it is rounding.");
}

TEST_CASE("the distance of reliability is the study's tolerance, or else what its plan says", "[estimand]") {
  const std::vector<GivenRun> runs{{"A", {0.01, 0.05, 0.2}}};
  CHECK(values(judged_runs(runs), Estimand::reliability).front() == Approx(1 / 3.0));
  CHECK(values(judged_runs(runs, R"(, "analysis": {"within_cm": 0.1})"), Estimand::reliability).front() ==
        Approx(2 / 3.0));
  CHECK(values(judged_runs(runs, R"(, "stop": {"tolerance_cm": 1}, "analysis": {"within_cm": 0.1})"),
               Estimand::reliability)
            .front() == 1);
}

TEST_CASE("a pose is within the distance where its angle is within the tolerance too", "[estimand]") {
  JudgedStudy study = judged_runs({{"A", {0.05, 0.05, 0.2}}},
                                  R"(, "search": "pose", "stop": {"tolerance_cm": 0.1, "tolerance_deg": 2})");
  // ||R - Rd|| / ||Rd|| of 1.9 deg is sqrt(8 / 3) sin(0.95 deg) = 0.0270748, of 2.1 deg it is 0.0299245.
  study.solves.to_change()[0].orientation_error = 0.0270748;
  study.solves.to_change()[1].orientation_error = 0.0299245;
  study.solves.to_change()[1].status = study.solves.to_change()[2].status = Status::tolerance_missed;
  CHECK(values(study, Estimand::reliability).front() == Approx(1 / 3.0));
  CHECK(observations(study, position_error, Estimand::reliability).quantity ==
        "share of solves within 0.1 cm and 2 deg, inside the joint limits");
  study.solves.to_change()[0].status = Status::limit_violated;
  CHECK(values(study, Estimand::reliability).front() == 0);
}

TEST_CASE("an answer that was refused or is not finite is within no distance, and leaves the typical value undefined",
          "[estimand]") {
  JudgedStudy study = judged_runs({{"A", {1e-3, 1e-3, never, 1e-3}}});
  study.solves.to_change()[0].status = Status::refused;
  CHECK(values(study, Estimand::reliability) == std::vector<double>{0.5});
  CHECK(std::isnan(values(study, Estimand::typical).front()));
  CHECK(std::isnan(values(study, Estimand::mean).front()));
}

TEST_CASE(
    "error has all the plan's estimands, time its typical value, reliability with a deadline alone, others the mean",
    "[estimand]") {
  using All = std::vector<Estimand>;
  const std::vector<GivenRun> runs{{"A", {1, 2}}};
  const JudgedStudy study = judged_runs(runs);
  CHECK(estimands_of(study, position_error) == All{Estimand::mean, Estimand::typical, Estimand::reliability});
  CHECK(estimands_of(study, Metric::seconds) == All{Estimand::typical});
  CHECK(estimands_of(study, Metric::variation_deg) == All{Estimand::mean});
  const JudgedStudy timed =
      judged_runs(runs, R"(, "stop": {"seconds": 1}, "analysis": {"estimands": ["reliability", "mean"]})");
  CHECK(estimands_of(timed, Metric::seconds) == All{Estimand::typical, Estimand::reliability});
  CHECK(observations(timed, Metric::seconds, Estimand::reliability).groups[0].values ==
        std::vector<double>{1});  // 1 s each
  CHECK(estimands_of(timed, position_error) == All{Estimand::mean, Estimand::reliability});
  // With a tolerance, in time is who solves it in time.
  JudgedStudy solved = judged_runs({{"A", {0.1, 5}}}, R"(, "deadline_ms": 2000, "stop": {"tolerance_cm": 1})");
  solved.solves.to_change()[1].status = Status::tolerance_missed;
  const Observations in_time = observations(solved, Metric::seconds, Estimand::reliability);
  CHECK(in_time.quantity == "share of solves solved within 2 s");
  CHECK(in_time.groups[0].values == std::vector<double>{0.5});
}

TEST_CASE("typical values are compared as logarithms and told as geometric means and ratios", "[estimand]") {
  const JudgedStudy study =
      judged_runs({{"A", {1e-3}}, {"A", {1e-4}}, {"A", {1e-5}}, {"B", {1e-1}}, {"B", {1e-2}}, {"B", {1e-3}}},
                  R"(, "analysis": {"test": "tamhane"})");
  const Evidence found = study.evidence(position_error, Estimand::typical);
  CHECK(found.groups[0].described.mean == Approx(1e-4));
  CHECK(found.groups[0].described.median == Approx(1e-4));
  CHECK(found.groups[0].described.std == Approx(1));  // of -3, -4 and -5
  const Finding& pair = found.contrasts.at(0);
  CHECK(pair.estimate.value == Approx(0.01));  // 1e-4 / 1e-2
  // Student's t of 4 degrees of freedom at 0.975 is 2.7764451 (tables); the standard error is sqrt(2 / 3).
  const double reach = 2.7764451 * std::sqrt(2.0 / 3);
  CHECK(pair.estimate.low == Approx(std::pow(10, -2 - reach)).epsilon(1e-6));
  CHECK(pair.estimate.high == Approx(std::pow(10, -2 + reach)).epsilon(1e-6));
  CHECK(judge(found, "B", "A").estimate.value == Approx(100));
  CHECK(judge(found, "B", "A").estimate.low == Approx(std::pow(10, 2 - reach)).epsilon(1e-6));
}

TEST_CASE("typical values are the same where their ratio is within the margin", "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 0; run < 40; ++run) {
    const double f = run % 2 == 0 ? 0.99 : 1 / 0.99;
    runs.push_back({"A", {1e-5 * f}});
    runs.push_back({"B", {1.01e-5 * f}});
  }
  CHECK(judge(judged_runs(runs).evidence(position_error, Estimand::typical), "A", "B").relation != Relation::undecided);
  const JudgedStudy study = judged_runs(runs, R"(, "analysis": {"margin_percent": 3})");
  CHECK(study.evidence(position_error, Estimand::typical).contrasts[0].is_within_margin());
  const JudgedStudy narrow = judged_runs(runs, R"(, "analysis": {"margin_percent": 1})");
  CHECK(!narrow.evidence(position_error, Estimand::typical).contrasts[0].is_within_margin());
}

TEST_CASE("each estimand may have another winner", "[estimand]") {
  const JudgedStudy study = judged_runs(three_winners());
  const auto is_better = [&](Estimand estimand, const char* first, const char* second) {
    CHECK(judge(study.evidence(position_error, estimand), first, second).relation == Relation::better);
  };
  // Means 0.02, 0.5 and 2; geometric means 0.02, sqrt(1e-6) and 0.009^0.8 10^0.2 = 0.0366, each times 1.0105 at most.
  is_better(Estimand::mean, "A", "B");
  is_better(Estimand::mean, "A", "C");
  is_better(Estimand::typical, "B", "A");
  is_better(Estimand::typical, "B", "C");
  is_better(Estimand::reliability, "C", "B");
  is_better(Estimand::reliability, "C", "A");
}

// Ten runs of four targets: A solves three of them at some cost; the liar stays where it is.
JudgedStudy with_a_liar(const std::string& more) {
  std::vector<GivenRun> runs;
  for (int run = 0; run < 10; ++run) {
    const double f = 1 + 0.01 * run;
    runs.push_back({"A", {0.001 * f, 0.002 * f, 0.003 * f, 5 * f}});
    runs.push_back({"liar", {50 * f, 60 * f, 70 * f, 80 * f}});
  }
  JudgedStudy study = judged_runs(runs, more);
  for (Solve& solve : study.solves.to_change()) {
    const bool lies = study.solvers[solve.solver] == "liar";
    solve.seconds = (lies ? 0.001 : 1) * (1 + 0.001 * solve.run);
    solve.evaluations = lies ? 1 : 1000 + solve.run;
    solve.variation_deg = lies ? 0 : 90 + 0.1 * solve.run;
    solve.status = lies ? Status::claimed_but_wrong : solve.point == 4 ? Status::tolerance_missed : Status::ok;
  }
  return study;
}

TEST_CASE("a solver that solves nothing leads in no cost of a study with a tolerance", "[estimand]") {
  const JudgedStudy study = with_a_liar(R"(, "stop": {"tolerance_cm": 0.01, "evaluations": 2000})");
  CHECK(primary_estimand(study) == Estimand::reliability);
  for (const Metric cost : {Metric::evaluations, Metric::variation_deg}) {
    CHECK(judge(study.evidence(cost, average_estimand(cost)), "A", "liar").relation == Relation::better);
  }
  const Observations evaluations = observations(study, Metric::evaluations);
  CHECK(evaluations.quantity == "evaluations (failures: 10 times the limit)");
  CHECK(evaluations.groups[0].values[0] == Approx((3 * 1001 + 20000) / 4.0));
  CHECK(evaluations.groups[1].values[0] == 20000);  // 10 times 2000
  const Observations variation = observations(study, Metric::variation_deg);
  CHECK(variation.quantity == "angles variation (failures: 10 times the dearest solve) [deg]");
  CHECK(variation.groups[1].values[0] == Approx(910));  // 10 times the largest
  const StudyResults other = of_solvers(study, [](std::string_view solver) { return solver == "liar"; });
  CHECK(observations(other, Metric::variation_deg).groups[0].style == 2);       // as in the whole study
  CHECK(observations(other, Metric::variation_deg).groups[0].values[0] == 10);  // no solve cost anything
}

TEST_CASE("the margin of shares is percentage points, whether they are outcomes or shares of a run", "[estimand]") {
  Observations shares{.name = "solved",
                      .quantity = "share of solves",
                      .better = Better::larger,
                      .scale = ValueScale::share,
                      .groups = {{.name = "A"}, {.name = "B"}}};
  for (int run = 0; run < 20; ++run) {
    const double chance = 0.01 * (run % 5 - 2);
    shares.groups[0].values.push_back(0.50 + chance);
    shares.groups[1].values.push_back(0.53 - chance);
  }
  const Evidence judged = evidence(shares, {});  // by means: 5 % of 0.5 would be 2.5 points
  CHECK(judged.contrasts.front().is_within_margin());
  CHECK(report::verdict_words(judged, judged.contrasts.front()) == "B is better by less than 5 percentage points");
  const Evidence across = evidence(shares, {.margin = 0.03});
  CHECK(contains(report::verdict_words(across, across.contrasts.front()),
                 " percentage points (margin 3 percentage points)"));
  for (Group& group : shares.groups) {
    for (double& value : group.values) value = 1;
  }
  const Evidence outcomes = evidence(shares, {});
  CHECK(outcomes.of_outcomes);
  CHECK(outcomes.contrasts.front().relation == Relation::undecided);
  CHECK(report::verdict_words(outcomes, outcomes.contrasts.front()) == "undecided");
}

TEST_CASE("logarithms of 1 and 10 are no outcomes", "[estimand]") {
  const Observations logarithms{
      .name = "x",
      .quantity = "typical x",
      .scale = ValueScale::log10,
      .groups = {{.name = "A", .values = {0, 1, 0, 1, 1}}, {.name = "B", .values = {1, 0, 1, 1, 1}}}};
  CHECK(!evidence(logarithms, {}).of_outcomes);
}

TEST_CASE("who gives up on dear targets is not cheaper, also without a limit", "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 0; run < 20; ++run) {
    for (const char* solver : {"quits", "works"}) runs.push_back({solver, {0.001}});
  }
  JudgedStudy study = judged_runs(runs, R"(, "stop": {"tolerance_cm": 0.01})");
  for (Solve& solve : study.solves.to_change()) {
    const bool quits = study.solvers[solve.solver] == "quits", is_dear = solve.run % 5 != 0;
    solve.evaluations = quits ? 1 : is_dear ? 1000 + solve.run : 10;
    solve.status = quits && is_dear ? Status::tolerance_missed : Status::ok;
  }
  CHECK(judge(study.evidence(Metric::evaluations, Estimand::mean), "works", "quits").relation == Relation::better);
}

TEST_CASE("below the tolerance no error is better than another", "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 0; run < 20; ++run) {
    runs.push_back({"A", {1e-6 * (1 + run), 1e-6}});
    runs.push_back({"B", {1e-3 * (1 + run), 1e-3}});
  }
  const JudgedStudy study = judged_runs(runs, R"(, "stop": {"tolerance_cm": 0.1})");
  for (const Estimand estimand : {Estimand::mean, Estimand::typical}) {
    CHECK(judge(study.evidence(position_error, estimand), "A", "B").relation == Relation::same);
  }
  CHECK(values(study, Estimand::mean).front() == 0.1);
  CHECK(judge(judged_runs(runs).evidence(position_error, Estimand::mean), "A", "B").relation == Relation::better);
}

TEST_CASE("two solvers that repeat themselves differ by a fact without a test, however many runs there are",
          "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 0; run < 20; ++run) {
    runs.push_back({"A", {0.1, 0.3}});
    runs.push_back({"B", {0.2, 0.6}});
  }
  JudgedStudy study = judged_runs(runs);
  for (Solve& solve : study.solves.to_change()) solve.answer = 1 + solve.solver;  // one for all its runs
  const Evidence& found = study.evidence(position_error, Estimand::mean);
  CHECK(found.groups[0].described.n == 1);
  CHECK(std::isnan(found.contrasts.at(0).p));
  CHECK(found.contrasts[0].is_fact);
  CHECK(found.contrasts[0].relation == Relation::better);
}

TEST_CASE("the runs of a solver are held against the known value of one that repeats itself", "[estimand]") {
  const auto study_with = [](double farthest) {
    std::vector<GivenRun> runs;
    for (int run = 0; run < 8; ++run) {
      runs.push_back({"A", {0.1, 0.3}});
      runs.push_back({"B", {0.3 + 0.01 * run, run == 7 ? farthest : 0.5}});
    }
    JudgedStudy study = judged_runs(runs);
    std::uint32_t answer = 1;
    for (Solve& solve : study.solves.to_change()) solve.answer = solve.solver == 0 ? 1 : ++answer;
    return study;
  };
  const JudgedStudy study = study_with(0.5);
  const Finding& found = study.evidence(position_error, Estimand::mean).contrasts.at(0);
  CHECK(found.relation == Relation::better);
  CHECK(found.p == Approx(2 * std::exp2(-8)));  // the sign test: all eight runs are above 0.2 cm
  const JudgedStudy across = study_with(-0.5);
  CHECK(across.evidence(position_error, Estimand::mean).contrasts.at(0).relation == Relation::undefined);
}
