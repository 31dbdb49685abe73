// A deciding test more: tests/examples/analysis/inference/methods/scheffe.cpp and its line in
// results/deciding_tests.inc.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/report/assessment.hpp"
#include "analysis/report/table.hpp"
#include "cli/plan_options.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;

TEST_CASE("a deciding test is a file and a line: help, plan, sentences, tables and JSON have it", "[methods]") {
  CLI::App app;
  AnalysisPlan plan;
  cli::add_plan_options(app, plan);
  CHECK(contains(app.help(), "friedman, scheffe"));
  app.parse("--test scheffe");
  CHECK(plan.test == "scheffe");

  // By hand: the variance within is 1 with 6 degrees of freedom, so A and B are 24 squared standard errors apart, and
  // P(F(2, 6) > 24 / 2) = (1 + 2 * 12 / 6)^-3. The quantile of F(2, 6) at 0.95 is 3 (20^(1/3) - 1).
  const Observations three{
      .name = "x", .quantity = "x", .groups = {{"A", {1, 2, 3}}, {"B", {5, 6, 7}}, {"C", {2, 3, 4}}}};
  const Evidence found = evidence(three, plan);
  CHECK(found.method->name == "scheffe");
  CHECK(found.contrasts[0].estimate.value == Approx(-4));
  CHECK(found.contrasts[0].estimate.high == Approx(-4 + 2.618714));
  CHECK(found.contrasts[0].p == Approx(0.008));
  CHECK(found.contrasts[0].relation == Relation::better);
  CHECK(found.contrasts[1].p == Approx(0.512));

  const report::Assessment told = report::assess(three, plan);
  CHECK(contains(report::paragraph_of(told.sentences), "Decided by: Scheffe's test, corrected for 3 pairs."));
  CHECK(contains(report::to_csv(told.tables.back()), "A,B,A is better"));
  const nlohmann::json json = nlohmann::json::parse(told.json);
  CHECK(json["plan"]["test"] == "scheffe");
  CHECK(json["method"] == "Scheffe's test");
  CHECK(plan_of({.name = "x", .definition = R"({"analysis": {"test": "scheffe"}})", .series = {}}).test == "scheffe");
}
