#include "tests/judge/studies.hpp"

namespace {

const JudgedMetric& metric(const JudgedStudy& of, std::string_view slug) {
  const auto found = std::ranges::find(of.metrics, slug, [](const JudgedMetric& each) { return each.samples.metric; });
  REQUIRE(found != of.metrics.end());
  return *found;
}

std::string slugs(const JudgedStudy& of) {
  std::string all;
  for (const JudgedMetric& each : of.metrics) all += each.samples.metric + " ";
  return all;
}

bool has_warning(const std::vector<Warning>& warnings, WarningKind kind) {
  return std::ranges::find(warnings, kind, &Warning::kind) != warnings.end();
}

}  // namespace

TEST_CASE("A report has the metrics that a study has, and is decided by the plan's, solved or the error") {
  const auto as_made = [](SolveRecord&) {};
  const JudgedStudy of = judge::judge(study({}, as_made));
  CHECK(slugs(of) == "error variation time evaluations ");
  CHECK(of.primary == 0);
  const JudgedStudy with = judge::judge(study({.tolerance_cm = 1}, as_made));
  CHECK(slugs(with) == "solved variation time evaluations ");
  CHECK(with.primary == 0);
  const JudgedStudy by_error =
      judge::judge(study({.tolerance_cm = 1, .rest = R"(, "analysis": {"metric": "position_error_cm"})"}, as_made));
  CHECK(slugs(by_error) == "solved error variation time evaluations ");
  const JudgedStudy planned = judge::judge(study({.rest = R"(, "analysis": {"metric": "iterations"})"}, as_made));
  CHECK(slugs(planned) == "error variation time evaluations iterations ");
  CHECK(planned.primary == 4);
  CHECK_THROWS_AS(judge::judge(study({.rest = R"(, "analysis": {"metric": "beauty"})"}, as_made)),
                  std::invalid_argument);
}

TEST_CASE("Of equal solvers the one with fewer evaluations comes first") {
  JudgedStudy of = judge::judge(study({.runs = 8}, [](SolveRecord& solve) {
    solve.position_error_cm = 0.01 * solve.run;
    solve.evaluations = solve.label == "A" ? 200 : 100;
  }));
  CHECK(display_order(metric(of, "error"), of.metrics) == std::vector<std::size_t>{1, 0});
  for (JudgedMetric& each : of.metrics)
    each.samples.quantity_kind = QuantityKind::other;  // as a file's column of that name
  CHECK(display_order(metric(of, "error"), of.metrics) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("The plan's test, level, margin and control reach the comparison") {
  const auto errors = [](SolveRecord& solve) {
    solve.position_error_cm = (solve.label == "A" ? 1 : 1.5) + 0.01 * solve.run;
  };
  const auto judged = [&](const std::string& plan) {
    return metric(judge::judge(study({.runs = 8, .rest = R"(, "analysis": )" + plan}, errors, {"A", "B", "C"})),
                  "error");
  };
  CHECK(flat(judged(R"({"test": "means"})").comparisons.front()).test == "Welch's t");
  CHECK(judged(R"({"control": "B"})").comparisons.size() == 2);
  CHECK(flat(judged(R"({"significance": 0.0001})").comparisons.front()).why == ResultKind::too_few);
  CHECK_FALSE(flat(judged(R"({})").comparisons.front()).is_within_margin);
  CHECK(flat(judged(R"({"margin_percent": 99})").comparisons.front()).is_within_margin);
}

TEST_CASE("Means that few values decide are told") {
  const Asked means{.runs = 8, .rest = R"(, "analysis": {"test": "means", "significance": 0.2, "tie_breakers": []})"};
  const JudgedMetric error = metric(judge::judge(study(means,
                                                       [](SolveRecord& solve) {
                                                         solve.position_error_cm = solve.label == "A" ? 0.01 * solve.run
                                                                                   : solve.run == 1
                                                                                       ? 9
                                                                                       : 1 + 0.01 * solve.run;
                                                       })),
                                    "error");
  REQUIRE(has_warning(error.samples.warnings, WarningKind::dominated_by_few));
  CHECK(error.samples.warnings.front().solvers == std::vector<std::string>{"B"});
}

TEST_CASE("Where nothing is solved, the error is reported and no cost") {
  CHECK(slugs(judge::judge(study({.start = "middle", .targets = "drawn", .tolerance_cm = 0.1}, [](SolveRecord& solve) {
          solve.status = Status::tolerance_missed;
        }))) == "solved error ");
}

TEST_CASE("Two identical solvers have no winner in the headline in 95 % of studies") {
  std::mt19937_64 engine(7);
  std::lognormal_distribution<double> error(-3, 1);
  std::bernoulli_distribution solves(0.9);
  const auto winners = [&](const Asked& asked) {
    int count = 0;
    for (int i = 0; i < 400; ++i) {
      const JudgedStudy of = judge::judge(study(asked, [&](SolveRecord& solve) {
        solve.position_error_cm = error(engine);
        if (!solves(engine)) solve.status = Status::tolerance_missed;
      }));
      count += is_difference(verdict_of(of.metrics[of.primary].comparisons.front()));
    }
    return count;
  };
  CHECK(winners({.runs = 10}) <= 30);  // 20 expected at most, plus 2.3 standard errors
  CHECK(winners({.start = "middle", .targets = "drawn", .runs = 10, .points = 2}) <= 30);
  CHECK(winners({.runs = 10, .tolerance_cm = 0.1}) <= 30);
  CHECK(winners({.start = "middle", .targets = "drawn", .runs = 20, .points = 2, .tolerance_cm = 0.1}) <= 30);
}
