// Mean, typical value and reliability of the same solves: by hand, and where each has another winner.
#include "analysis/inference/estimand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "analysis/inference/analysis_plan.hpp"
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

std::string text_of_assessment(const Assessment& assessment) {
  std::string text;
  for (const std::string& sentence : words_of(assessment.sentences)) text += sentence + '\n';
  return text;
}

std::string leaders_text(const JudgedStudy& study, Metric metric) {
  std::vector<Sentence> sentences;
  for (const Estimand estimand : estimands_of(study, metric)) add(sentences, leader_sentence(study, metric, estimand));
  return paragraph_of(sentences);
}

std::string leader_words(const JudgedStudy& study, Metric metric, Estimand estimand) {
  return words_of(leader_sentence(study, metric, estimand));
}

std::vector<std::string> own_words(const JudgedStudy& study) { return words_of(own_verdict(study)); }

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
                  R"(, "analysis": {"test": "welch"})");
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
  const std::string text = text_of_assessment(assess(observations(study, position_error, Estimand::typical),
                                                     AnalysisPlan{.test = "welch", .significance = 0.1}));
  // t is 2.1318468
  CHECK(contains(text, "A is better than B: geometric mean 0.0001 vs 0.01, by 1.82 to 5504 times, more than 5 %"));
  CHECK(contains(text, "a mean is a geometric mean, and a difference is a ratio"));
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

TEST_CASE("where each estimand has another winner, the first sentence names the estimand with its winner",
          "[estimand]") {
  const JudgedStudy study = judged_runs(three_winners());
  const std::string sentence = leaders_text(study, position_error);
  CAPTURE(sentence);
  // Means 0.02, 0.5 and 2; geometric means 0.02, sqrt(1e-6) and 0.009^0.8 10^0.2 = 0.0366, each times 1.0105 at most.
  CHECK(sentence.starts_with(
      "Smallest mean error (large errors dominate): A (0.0202 cm) is better than B (0.505 cm) and C (2.03 cm): p at most "));
  CHECK(contains(
      sentence,
      ". Smallest typical error (geometric mean): B (0.00101 cm) is better than A (0.0202 cm) and C (0.037 cm): p at most "));
  CHECK(contains(sentence, ". Most often within 0.01 cm: C (80 %) is better than B (50 %) and A (0 %): p at most "));
}

TEST_CASE("the verdict of a study without a paper is by one quantity, and the others are exploratory", "[estimand]") {
  const std::vector<std::string> lines = own_words(judged_runs(three_winners()));
  REQUIRE(lines.size() >= 4);
  CHECK(lines[0].starts_with("Smallest mean error (large errors dominate): A ("));
  CHECK(lines[1].starts_with("What would change it: "));
  CHECK(lines[2] == fmt::format("Exploratory: the verdict is by the quantity above. Nothing corrects for the {} other "
                                "quantities.",
                                lines.size() - 4));
  CHECK(lines[3].starts_with("Smallest typical error (geometric mean): B ("));
  CHECK(lines[lines.size() - 2].starts_with("Fewest evaluations: "));
  CHECK(lines.back() == "20 observations per group can miss what happens in up to 14 % of them.");
  const std::vector<std::string> typical =
      own_words(judged_runs(three_winners(), R"(, "analysis": {"estimands": ["typical", "reliability"]})"));
  CHECK(typical[0].starts_with("Smallest typical error (geometric mean): B ("));
  const std::vector<std::string> solved =
      own_words(judged_runs(three_winners(), R"(, "stop": {"tolerance_cm": 0.01})"));
  CHECK(solved[0].starts_with("Most often within 0.01 cm and inside the joint limits: "));
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
  for (const std::string& line : own_words(study)) {
    CAPTURE(line);
    CHECK(!contains(line, ": liar "));
  }
  const Observations evaluations = observations(study, Metric::evaluations);
  CHECK(evaluations.quantity == "evaluations (failures: 10 times the limit)");
  CHECK(evaluations.groups[0].values[0] == Approx((3 * 1001 + 20000) / 4.0));
  CHECK(evaluations.groups[1].values[0] == 20000);  // 10 times 2000
  const Observations variation = observations(study, Metric::variation_deg);
  CHECK(variation.quantity == "angles variation (failures: 10 times the dearest solve) [deg]");
  CHECK(variation.groups[1].values[0] == Approx(910));  // 10 times the largest
  CHECK(contains(leader_words(study, Metric::variation_deg, Estimand::mean),
                 "A (295 deg) is better than liar (910 deg)"));
  const StudyResults other = of_solvers(study, [](std::string_view solver) { return solver == "liar"; });
  CHECK(observations(other, Metric::variation_deg).groups[0].style == 2);       // as in the whole study
  CHECK(observations(other, Metric::variation_deg).groups[0].values[0] == 10);  // no solve cost anything
  CHECK(contains(leader_words(study, Metric::evaluations, Estimand::mean),
                 "Fewest evaluations (failures: 10 times the limit): A ("));
}

TEST_CASE("the verdict says who gave no answer, how often and why", "[estimand]") {
  JudgedStudy study = with_a_liar("");
  CHECK(report::no_answer_sentences(study).empty());
  for (Solve& solve : study.solves.to_change()) {
    if (study.solvers[solve.solver] == "liar") solve.status = solve.run == 1 ? Status::timed_out : Status::crashed;
  }
  CHECK(
      own_words(study)[1] ==
      "liar gave no answer in 40 of 40 solves (crashed and timed out): there its error is that of where the arm stood.");
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
  CHECK(contains(leader_words(study, Metric::evaluations, Estimand::mean), ": works ("));
}

TEST_CASE("who claims what the verifier does not find is named", "[estimand]") {
  CHECK(words_of(wrong_claims(with_a_liar(""))) == "Wrong claims: in 40 of 40 solves the error is not what liar said.");
  CHECK(wrong_claims(judged_runs({{"A", {1}}})).empty());
}

TEST_CASE("a look at other runs than an earlier one had says so, and the level that is left", "[estimand]") {
  const std::vector<Look> looks{{.runs = 5, .when = "2026-11-20T10:00:00Z"},
                                {.runs = 10, .when = "2026-11-21T10:00:00Z"}};
  CHECK(contains(words_of(look_doubts(looks, 5, 0.05)),
                 "look 2 at this study: earlier ones were after 10 (2026-11-21) runs"));
  CHECK(contains(words_of(look_doubts(looks, 10, 0.05)),
                 "look 2 at this study: earlier ones were after 5 (2026-11-20) runs, and"));
  CHECK(contains(words_of(look_doubts(looks, 20, 0.05)),
                 "only if p is below 0.00833. Then all looks after the first are wrong in at most 5 % of studies."));
  CHECK(level_of_look(looks, 20, 0.05) == Approx(0.05 / 6));
  CHECK(level_of_look(looks, 10, 0.05) == Approx(0.05 / 2));
  CHECK(level_of_look({}, 10, 0.05) == 0.05);
  CHECK(look_doubts({}, 20, 0.05).empty());
}

TEST_CASE("without a tolerance a cost has the error beside it", "[estimand]") {
  const JudgedStudy study = with_a_liar("");
  const std::string fewest = leader_words(study, Metric::evaluations, Estimand::mean);
  CAPTURE(fewest);
  CHECK(fewest.starts_with(
      "Fewest evaluations: liar (1 with error 67.9 cm) is better than A (1006 with error 1.31 cm): p = "));
  CHECK(!contains(leader_words(study, position_error, Estimand::mean), "with error"));
}

TEST_CASE("a mean that is lifted to the tolerance says so", "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 1; run <= 20; ++run) {
    runs.push_back({"A", {1e-3 * run}});
    runs.push_back({"B", {1e-5 * run}});
    runs.push_back({"C", {1 + 1e-3 * run}});
  }
  const JudgedStudy study = judged_runs(runs, R"(, "stop": {"tolerance_cm": 0.1})");
  const std::string sentence = leader_words(study, position_error, Estimand::mean);
  CAPTURE(sentence);
  CHECK(contains(sentence, "A (at most 0.1 cm) is better than C (1.01 cm): p = "));
  CHECK(contains(sentence, ". A and B (at most 0.1 cm) are the same within 5 %."));
}

TEST_CASE("solvers that a first one is not tested against have their values", "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 1; run <= 20; ++run) {
    runs.push_back({"A", {1 + 0.01 * run}});
    runs.push_back({"B", {2 + 0.01 * run}});
  }
  runs.push_back({"C", {1.5}});
  runs.push_back({"D", {90}});
  const std::string sentence = leader_words(judged_runs(runs), position_error, Estimand::mean);
  CAPTURE(sentence);
  CHECK(contains(sentence, ". A cannot be judged against C (1.5 cm) and D (90 cm)."));
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
    CHECK(contains(leader_words(study, position_error, estimand), "the same within 5 %"));
    CHECK(contains(leader_words(study, position_error, estimand), "below 0.1 cm counts as 0.1 cm"));
  }
  CHECK(values(study, Estimand::mean).front() == 0.1);
  CHECK(contains(fmt::format("{}", fmt::join(observations(study, position_error).counting, " ")),
                 "An error below the tolerance of 0.1 cm counts as 0.1 cm: below it solvers are the same."));
  CHECK(judge(judged_runs(runs).evidence(position_error, Estimand::mean), "A", "B").relation == Relation::better);
}

TEST_CASE("the first is whom the test is for, not whom the mean is for", "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 0; run < 20; ++run) {
    runs.push_back({"A", {run == 0 ? 3.0 : 1.0 + 0.001 * run}});  // better in nineteen of twenty runs
    runs.push_back({"B", {1.05 + 0.001 * run}});
  }
  const JudgedStudy study = judged_runs(runs, R"(, "analysis": {"test": "kruskal_wallis", "estimands": ["mean"]})");
  const std::string sentence = leaders_text(study, position_error);
  CHECK(sentence.starts_with(
      "Smallest mean error (large errors dominate): A (1.11 cm) is better by ranks than B (1.06 cm): p = "));
  CHECK(contains(sentence, " and the mean favours the other."));
}

TEST_CASE("with a control the first line is the verdict on it, and no other pair is undecided", "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 0; run < 20; ++run) {
    const double f = 0.001 * run;
    runs.push_back({"C", {1 + f}});
    runs.push_back({"near", {1.001 + 1.1 * f}});
    runs.push_back({"far", {2 + f}});
    runs.push_back({"best", {0.5 + f}});
    runs.push_back({"good", {0.5 + 1.1 * f}});
  }
  const JudgedStudy study =
      judged_runs(runs, R"(, "analysis": {"control": "C", "estimands": ["mean"], "margin_percent": 0})");
  const std::string sentence = leaders_text(study, position_error);
  CAPTURE(sentence);
  CHECK(contains(sentence, "control C (1.01 cm) is better than far (2.01 cm): p = "));
  CHECK(contains(sentence, ". C is worse than best (0.51 cm) and good (0.51 cm): p at most "));
  CHECK(contains(sentence, ". C against near (1.01 cm) is undecided: p = "));
}

TEST_CASE("those that the test does not separate from the first share its place", "[estimand]") {
  const auto sentence_of = [](const std::vector<GivenRun>& runs) {
    return leaders_text(judged_runs(runs, R"(, "analysis": {"test": "welch", "estimands": ["mean"]})"), position_error);
  };
  const std::string label = "Smallest mean error (large errors dominate): ";
  CHECK(sentence_of({{"A", {1}}, {"A", {2}}, {"A", {3}}, {"B", {1.5}}, {"B", {2}}, {"B", {3}}})
            .starts_with(label + "A (2 cm) against B (2.17 cm) is undecided: p = "));
  CHECK(sentence_of({{"A", {1}}, {"A", {2}}, {"B", {3}}, {"B", {2}}, {"C", {4}}, {"C", {2}}}) ==
        label + "A (1.5 cm) against B (2.5 cm) and C (3 cm) is undecided.");
  CHECK(sentence_of({{"A", {1}}, {"B", {2}}}) == label + "no solver is tested: A (1 cm) and B (2 cm).");  // a run each
  CHECK(sentence_of({{"A", {1}}, {"A", {2}}}) == label + "A (1.5 cm).");
  CHECK(sentence_of({{"A", {never}}}).empty());
  const auto same = [](const char* solver, double value) {
    return std::vector<GivenRun>(5, GivenRun{solver, {value}});
  };
  std::vector<GivenRun> runs = same("A", 2), others = same("B", 2);
  runs.insert(runs.end(), others.begin(), others.end());
  CHECK(sentence_of(runs) ==
        label + "A (2 cm) and B (2 cm) are the same within 5 %: equal bit for bit in every solve.");
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
  CHECK(
      leaders_text(study, position_error)
          .starts_with(
              "Smallest mean error (large errors dominate): A (0.2 cm) is better than B (0.4 cm): a fact of these targets, "
              "because all runs are equal."));
  const Evidence& found = study.evidence(position_error, Estimand::mean);
  CHECK(found.groups[0].described.n == 1);
  CHECK(std::isnan(found.contrasts.at(0).p));
  CHECK(found.contrasts[0].is_fact);
  CHECK(found.contrasts[0].relation == Relation::better);
  const std::string text = text_of_assessment(assess(study, position_error, Estimand::mean));
  CHECK(contains(text, "Equal runs are one observation: A (20 runs), B (20 runs) gave the same answers in every run"));
  CHECK(!contains(text, "p = "));
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

TEST_CASE("points as observations have no test, and so no first", "[estimand]") {
  CHECK(contains(leaders_text(judged_runs(three_winners(), R"(, "analysis": {"unit": "point"})"), position_error),
                 "Most often within 0.01 cm: no solver is tested: C (80 %), B (50 %) and "));
}

TEST_CASE("the caution about decades looks at the solves and not at the means of runs", "[estimand]") {
  std::vector<GivenRun> runs;
  for (int run = 0; run < 10; ++run) {
    runs.push_back({"A", {1e-6, 1e-4, 1e-2, 1 + 0.01 * run}});  // the means are alike
    runs.push_back({"B", {0.1, 0.2, 0.3, 0.4 + 0.01 * run}});
  }
  const JudgedStudy study = judged_runs(runs);
  const std::string of_means = text_of_assessment(assess(observations(study, position_error), {}));
  CHECK(contains(of_means, "Caution: the single values of A (6) span more than two decades"));
  for (const Estimand estimand : {Estimand::typical, Estimand::reliability}) {
    CHECK(!contains(text_of_assessment(assess(observations(study, position_error, estimand), {})), "Caution"));
  }
}
