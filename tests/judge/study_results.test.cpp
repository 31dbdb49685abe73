#include "tests/judge/studies.hpp"

using namespace ikbench::base;
using namespace ikbench::results;

TEST_CASE("A study has the solves of each solver by run and point, and the sessions that made them") {
  const Asked asked{.runs = 2, .points = 2};
  const std::vector<SolveRecord> solves = planned_solve_count(
      asked, {"A", "B"}, [](SolveRecord& solve) { solve.extras["left"] = solve.point == 1 ? 3.0 : unknown; });
  const StudyResults study = to_stored(entry_of(asked, {"A", "B"}), solves, {{.id = 1}, {.id = 2}});
  REQUIRE(study.of("B").size() == 4);
  CHECK(study.of("B")[1].point == 2);
  CHECK(study.of("B")[2].run == 2);
  CHECK(study.of("nobody").empty());
  CHECK(study.extras.at("left").at("B") == std::vector{3.0, 3.0});
  CHECK(study.sessions.size() == 2);
  CHECK(study.definition.runs == 2);
  CHECK(study.definition.points == 2);
}

TEST_CASE("Solvers of a study have the same targets, and starts but where their own answers left the arm") {
  const Asked chained{.start = "previous"}, unchained{.start = "middle"};
  const auto other_target = [](SolveRecord& solve) { solve.target_position_m[1] = solve.label == "B" ? 1e-12 : 0; };
  const auto other_start = [](int point) {
    return [=](SolveRecord& solve) { solve.start_rad = {solve.label == "B" && solve.point == point ? 1.0 : 0.0}; };
  };
  const std::string place = "study hand-made, run 1, point ";
  CHECK_THROWS_WITH(study(chained, other_target), StartsWith(place + "1: A and B had different targets"));
  CHECK_THROWS_WITH(study(chained, other_start(1)), StartsWith(place + "1: A and B had different starts"));
  CHECK_THROWS_WITH(study(unchained, other_start(2)), StartsWith(place + "2: A and B had different starts"));
  const std::vector<std::string> labels{"A", "B", "C"};
  std::vector<SolveRecord> solves = planned_solve_count(unchained, labels, other_target);
  std::erase_if(solves, [](const SolveRecord& solve) { return solve.label == "A"; });  // has solved nothing
  CHECK_THROWS_WITH(to_stored(entry_of(unchained, labels), solves),
                    StartsWith(place + "1: B and C had different targets"));
  CHECK_NOTHROW(study(chained, other_start(2)));
}

TEST_CASE("In a loop a timed solve is late beyond the period, or without an answer") {
  const StudyResults of = study({.runs = 1, .rest = R"(, "loop": {"period_ms": 2})"}, [](SolveRecord& solve) {
    if (solve.point == 1) solve.status = Status::crashed;
    solve.seconds = solve.point < 3 ? 0.001 * solve.point : 0.003;
    if (solve.point == 4) solve.timing = Timing::parallel;
  });
  for (const SolveSummary& solve : of.of("A")) CHECK(solve.missed_deadline == (solve.point % 2 == 1));
}

TEST_CASE("In a loop a joint is too fast beyond its velocity; one without limits goes the shorter way") {
  for (const std::string limits : {"\"none\"", "[-360, 360]"}) {
    const Asked asked{.runs = 1,
                      .rest = R"(, "loop": {"period_ms": 500}, "arm": {"velocity_deg_s": [90], "links": )"
                              R"([{"limits_deg": )" +
                              limits + "}]}"};
    const StudyResults of =
        study(asked, [](SolveRecord& solve) { solve.start_rad = {3.1}, solve.answer_rad = {-3.1}; });
    for (const SolveSummary& solve : of.of("A"))
      CHECK(solve.exceeds_velocity == (limits != "\"none\"" && solve.point > 1));
  }
}

TEST_CASE("A control that is no solver is none") {
  const Asked asked{.rest = R"(, "analysis": {"control": "gone"})"};
  CHECK(study(asked, [](SolveRecord&) {}).definition.plan.control.empty());
}

TEST_CASE("Solves of another version are counted where its own are missing") {
  const auto by_another = [](SolveRecord& solve) { solve.series = solve.label == "B" ? "B@0" : ""; };
  const StudyResults of = study({.runs = 2, .points = 2}, by_another);
  CHECK(of.of("A").size() == 4);
  CHECK(of.of("B").empty());
  CHECK(of.stale_solves.count == 4);
  CHECK(of.stale_solves.solvers == std::vector<std::string>{"B"});
}
