// The table for an article: its numbers, its best and its stars are those of the evidence.
#include "analysis/report/article_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/inference/make_study.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

JudgedStudy judged(const AnalysisPlan& plan = {}) {
  StudyResults study = make_study("study", synthetic::solves({.solvers = {"A", "B", "C"}, .runs = 12, .points = 4}));
  study.plan = plan;
  return JudgedStudy(std::move(study));
}

const AverageCell& average_at(const Table& table, std::size_t row, const std::string& column) {
  const auto found = std::ranges::find(table.columns, column);
  REQUIRE(found != table.columns.end());
  return std::get<AverageCell>(table.rows.at(row).at(static_cast<std::size_t>(found - table.columns.begin())));
}

}  // namespace

TEST_CASE("a table for an article has the numbers, the best and the findings that the report has", "[article]") {
  const JudgedStudy study = judged();
  const Table table = article_table(study);
  const Evidence& evidence = study.evidence(Metric::position_error_cm, Estimand::mean);
  CHECK(table.name == "paper");
  CHECK(table.rows.size() == 3);
  CHECK(table.notes.empty());
  for (std::size_t i = 0; i < 3; ++i) {
    const AverageCell& average = average_at(table, i, "position_error_cm");
    CHECK(average.value == evidence.groups[i].described.mean);
    CHECK(average.spread == std::vector{evidence.groups[i].described.std});
    CHECK(average.is_best == (i == 0));
    CHECK(average.differs == (i > 0 && is_decided(*finding_of(evidence.contrasts, 0, i))));
  }
  CHECK(average_at(table, 1, "position_error_cm").differs);
  CHECK(contains(table.caption, "Mean ± standard deviation"));
  CHECK(contains(table.caption, "over runs (n = 12)"));
  CHECK(contains(table.caption, "Star: these averages are found to differ from the best"));
}

TEST_CASE("a plan of typical errors gives geometric means, which its test compares, with quartiles", "[article]") {
  const JudgedStudy study = judged({.estimands = {Estimand::typical, Estimand::mean}});
  const Evidence& evidence = study.evidence(Metric::position_error_cm, Estimand::typical);
  const Table table = article_table(study);
  const AverageCell& average = average_at(table, 2, "position_error_cm");
  CHECK(average.value == evidence.groups[2].described.mean);
  CHECK(average.value != evidence.groups[2].median.value);
  CHECK(average.spread == std::vector{evidence.groups[2].q1, evidence.groups[2].q3});
  CHECK(contains(table.caption, "geometric mean [quartiles]"));
}

TEST_CASE("stars of a plan with a control are differences from it", "[article]") {
  const Table table = article_table(judged({.control = "B"}));
  CHECK(average_at(table, 0, "position_error_cm").differs);
  CHECK(average_at(table, 0, "position_error_cm").is_best);
  CHECK(!average_at(table, 1, "position_error_cm").differs);
  CHECK(contains(table.caption, "found to differ from B"));
}

TEST_CASE("a table of one solver has no marks", "[article]") {
  const JudgedStudy study(make_study("study", synthetic::solves({.solvers = {"A"}, .runs = 3, .points = 2})));
  const Table table = article_table(study);
  CHECK(!average_at(table, 0, "position_error_cm").is_best);
  CHECK(!contains(table.caption, "Star"));
}

TEST_CASE("what is not compared has no marks, and the caption says so", "[article]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"A", "B"}, .runs = 5, .points = 2});
  for (SolveRecord& solve : solves) solve.timing = Timing::parallel;
  const Table table = article_table(JudgedStudy(make_study("study", std::move(solves))));
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(!average_at(table, i, "seconds").is_best);
    CHECK(!average_at(table, i, "seconds").differs);
  }
  CHECK(contains(table.caption, "Not compared: computing time."));
}
