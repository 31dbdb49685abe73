#include "results/definition.hpp"

#include <stdexcept>

#include "tests/catch.hpp"

using ikbench::results::Definition;
using ikbench::results::definition_of;

TEST_CASE("A definition is read into plain data") {
  const Definition of = definition_of(R"({"title": "T", "published": "p", "robot": "r", "search": "pose",
    "start": "previous", "limits": "enforced", "runs": 3, "points": 7, "seed": 9007199254740993, "deadline_ms": 5.5,
    "path": {"kind": "random", "points": 2, "targets": "drawn"},
    "stop": {"iterations": 200, "tolerance_cm": 0.1, "tolerance_deg": 2, "evaluations": 4000, "seconds": 0.5},
    "departures": ["limits", 4], "missing_solvers": ["BA"], "out_of_reach": {"points": 3}, "arm": {"links": []}})");
  CHECK(of.title == "T");
  CHECK(of.published == "p");
  CHECK(of.robot == "r");
  CHECK(of.search == "pose");
  CHECK(of.is_chained());
  CHECK(of.limits == "enforced");
  CHECK(of.runs == 3);
  CHECK(of.points == 7);
  CHECK(of.seed == 9007199254740993);
  CHECK(of.deadline_ms == 5.5);
  CHECK(of.path == "random");
  CHECK(of.draws_targets);
  CHECK(of.stop.iterations == 200);
  CHECK(of.stop.tolerance_cm == 0.1);
  CHECK(of.stop.tolerance_deg == 2);
  CHECK(of.stop.evaluations == 4000);
  CHECK(of.stop.seconds == 0.5);
  CHECK(of.departures == std::vector<std::string>{"limits"});
  CHECK(of.missing_solvers == std::vector<std::string>{"BA"});
  CHECK(of.out_of_reach == 3);
  CHECK(of.arm.contains("links"));
  CHECK(of.plan == ikbench::results::Plan());
}

TEST_CASE("A member that lacks or has another type keeps its default") {
  const Definition of =
      definition_of(R"({"title": 4, "runs": "many", "points": -3, "path": [], "stop": {"seconds": null}})");
  CHECK(of.title.empty());
  CHECK(of.runs == 0);
  CHECK(of.points == 0);
  CHECK(of.stop.seconds == 0);
  CHECK_FALSE(of.has_tolerance());
  CHECK_FALSE(of.is_chained());
  CHECK(definition_of(R"({"runs": 99999999999})").runs == 2147483647);
  CHECK(definition_of(R"({"path": {"points": 20}})").points == 20);
  for (const char* text : {"", "[]", "4", "{"}) CHECK_THROWS_AS(definition_of(text), std::invalid_argument);
}

TEST_CASE("A plan is read, and tests that are gone are ranks, or means in the paper's studies") {
  const auto plan_in = [](const std::string& analysis, const std::string& published = "") {
    return definition_of(R"({"published": ")" + published + R"(", "analysis": )" + analysis + "}").plan;
  };
  const ikbench::results::Plan plan =
      plan_in(R"({"test": "means", "metric": "seconds", "control": "A", "significance": 0.01,
                                "margin_percent": 10, "margin_cm": 0.2})");
  CHECK(plan.test == ikbench::results::Plan::Test::means);
  CHECK(plan.metric == "seconds");
  CHECK(plan.control == "A");
  CHECK(plan.significance == 0.01);
  CHECK(plan.margin == 0.1);
  CHECK(plan.margin_cm == 0.2);
  CHECK(plan_in(R"({"test": "by_design", "quartiles": 5})").test == ikbench::results::Plan::Test::ranks);
  CHECK(plan_in(R"({"test": "by_design"})", "slim2023").test == ikbench::results::Plan::Test::means);
  CHECK(plan_in(R"({"test": "ranks"})", "slim2023").test == ikbench::results::Plan::Test::ranks);
  for (const char* wrong :
       {R"({"significance": 0})", R"({"significance": 2})", R"({"margin_percent": 100})", R"({"margin_cm": -1})"}) {
    CHECK_THROWS_AS(plan_in(wrong), std::invalid_argument);
  }
}
