// The definition of a study in a store, as judging reads it.
#include "tests/results/samples.hpp"

TEST_CASE("A definition is read into plain data") {
  const StudyDefinition of = parse_definition(R"({"title": "T", "published": "p", "robot": "r", "search": "pose",
    "start": "previous", "limits": "enforced", "runs": 3, "points": 7, "seed": 9007199254740993,
    "path": {"kind": "random", "points": 2, "targets": "drawn"},
    "stop": {"iterations": 200, "tolerance_cm": 0.1, "tolerance_deg": 2, "evaluations": 4000, "seconds": 0.5},
    "departures": ["limits"], "unreachable_targets": {"points": 3}, "loop": {"period_ms": 500},
    "analysis": {"test": "means", "control": "A", "margin_percent": 10, "margin_cm": 0.2},
    "figures": {"width_cm": 9, "palette": ["#ff0000"], "solvers": ["B", "A"], "colours": {"A": "#8D1804"}},
    "arm": {"velocity_deg_s": [90, 2], "links": [{"limits_deg": "none"}, {"joint": "slides", "limits_deg": [0, 1]}]}})");
  CHECK(of.title == "T");
  CHECK(of.published == "p");
  CHECK(of.robot == "r");
  CHECK(of.search == Search::pose);
  CHECK(of.is_chained());
  CHECK(of.limits == LimitPolicy::enforced);
  CHECK(of.runs == 3);
  CHECK(of.points == 7);
  CHECK(of.seed == 9007199254740993);
  CHECK(of.path == "random");
  CHECK(of.draws_targets);
  CHECK(of.stop.iterations == 200);
  CHECK(of.stop.tolerance_cm() == 0.1);
  CHECK(of.stop.tolerance_deg() == 2);
  CHECK(of.stop.evaluations == 4000);
  CHECK(of.stop.seconds == 0.5);
  CHECK(of.departures == std::vector<std::string>{"limits"});
  CHECK(of.unreachable_targets == 3);
  CHECK(of.max_steps == std::vector<std::pair<double, bool>>{{45 * degree, true}, {1, false}});  // rad, and m
  CHECK(of.arm.starts_with("{\"links\""));
  CHECK(of.plan == AnalysisPlan{.test = AnalysisPlan::Test::means, .control = "A", .margin = 0.1});
  CHECK(of.figures ==
        FigureStyle{.width_cm = 9, .palette = {"#ff0000"}, .solvers = {"B", "A"}, .colours = {{"A", "#8D1804"}}});
}

TEST_CASE("A member that lacks keeps its default") {
  const StudyDefinition of = parse_definition(R"({"stop": {"seconds": null}, "departures": []})");
  CHECK(of.title.empty());
  CHECK(of.points == 0);
  CHECK(of.stop.seconds == 0);
  CHECK_FALSE(of.has_tolerance());
  CHECK(of.plan == AnalysisPlan());
  CHECK(of.figures == FigureStyle());
}

TEST_CASE("A member of another type is refused by its name") {
  CHECK_THROWS_WITH(parse_definition(R"({"name": "mine", "runs": "many"})"),
                    ContainsSubstring("study mine: runs is \"many\"; expected a whole number"));
  CHECK_THROWS_WITH(parse_definition(R"({"name": "mine", "analysis": {"then": []}})"),
                    ContainsSubstring("study mine: then is now called tie_breakers"));
  for (const char* text : {"", "[]", "4", "{", R"({"title": 4})", R"({"points": -3})", R"({"runs": 99999999999})",
                           R"({"path": []})", R"({"departures": ["limits", 4]})", R"({"stop": {"seconds": "1"}})",
                           R"({"analysis": {"test": 3}})", R"({"figures": {"colours": {"B": 3}}})",
                           R"({"unreachable_targets": 3})", R"({"analysis": {"significance": 0}})",
                           R"({"figures": {"colours": {"A": "'"}}})", R"({"figures": {"font": "a'; !touch pwned"}})"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_definition(text), std::invalid_argument);
  }
}
