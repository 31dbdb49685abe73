// A deciding test more: tests/examples/analysis/inference/methods/yuen.cpp and its line in results/deciding_tests.inc.
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
  CHECK(contains(app.help(), "friedman, yuen"));
  app.parse("--test yuen");
  CHECK(plan.test == "yuen");

  // R's PairedData and WRS2 call it yuen.test: here by hand. Without the least and the largest of five: 3 and 7, each
  // of three values, whose winsorized variance 1 is 4 / 2 of 3 - 1: the standard error is sqrt(2 * 2 / 3).
  const Observations two{.name = "x", .quantity = "x", .groups = {{"A", {2, 1, 3, 4, 90}}, {"B", {7, 6, 8, 5, 100}}}};
  const Evidence found = evidence(two, plan);
  CHECK(found.method->name == "yuen");
  CHECK(found.contrasts[0].difference.value == Approx(-4));
  CHECK(found.contrasts[0].p == Approx(0.0257214).epsilon(1e-4));
  CHECK(found.contrasts[0].relation == Relation::better);

  const report::Assessment told = report::assess(two, plan);
  CHECK(contains(report::paragraph_of(told.sentences), "Decided by: Yuen's test."));
  CHECK(contains(report::to_csv(told.tables.back()), "A,B,A is better"));
  const nlohmann::json json = nlohmann::json::parse(told.json);
  CHECK(json["plan"]["test"] == "yuen");
  CHECK(json["method"] == "Yuen's test of trimmed means");
  CHECK(plan_of({.name = "x", .definition = R"({"analysis": {"test": "yuen"}})", .series = {}}).test == "yuen");
}
