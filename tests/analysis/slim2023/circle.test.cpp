#include "analysis/slim2023/circle.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "analysis/inference/make_study.hpp"
#include "analysis/slim2023/paper_figures.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::figures;
using namespace ikbench::report;
using namespace ikbench::slim2023;

namespace {

constexpr double degree = std::numbers::pi / 180;

StudyResults circle_study(std::vector<SolveRecord> solves,
                          const std::string& definition = synthetic::dobot_definition) {
  return make_study(StudyEntry{.name = "s", .definition = definition, .series = {}}, std::move(solves));
}

std::vector<std::string> names_of(const std::vector<Figure>& figures) {
  std::vector<std::string> names;
  for (const Figure& figure : figures) names.push_back(figure.name);
  return names;
}

void check_drawn(const std::vector<Figure>& figures) {
  const ScratchFolder folder;
  for (const FigureOutcome& outcome : write_figures(figures, folder.path / "figures", {}).outcomes) {
    CAPTURE(outcome.name, outcome.error);
    CHECK(outcome.rendered);
  }
  for (const std::string& file : files_in(folder.path)) {
    CAPTURE(file);
    CHECK((file == "figures/style.gp" || file.starts_with("figures/figure-")));
  }
}

}  // namespace

TEST_CASE("angles by the closed form are the 60 printed ones of Table 8", "[circle]") {
  const StudyResults study = circle_study(synthetic::dobot_solves());
  const Table table = *table_8(study);
  REQUIRE(table.rows.size() == 20);
  for (std::size_t row = 0; row < 20; ++row) {
    CAPTURE(row);
    CHECK(number_at(table, row, "point") == static_cast<double>(row + 1));
    CHECK(number_at(table, row, "largest_difference_deg") <= 0.05 + 1e-9);
    CHECK(number_at(table, row, "theta4_deg") == number_at(table, row, "theta1_deg"));
    CHECK(number_at(table, row, "paper_theta4_deg") == number_at(table, row, "paper_theta1_deg"));
  }
  CHECK(number_at(table, 0, "paper_theta2_deg") == 66.5);  // the printed Table 8
  CHECK(number_at(table, 11, "paper_error_cm") == 9.61e-14);
  CHECK(has_note(table, "fitted them to the angles of this table"));
  CHECK(contains(printed_angles_verdict(study),
                 "Table 8: All of the 60 printed angles (without theta4 = theta1) agree with ours within 0.05 deg"));
}

TEST_CASE("the verdict on the printed angles is counted", "[circle]") {
  std::vector<SolveRecord> solves = synthetic::dobot_solves();
  solves[4].answer_rad[0] += 0.2 * degree;  // theta1
  solves[6].answer_rad[2] -= 40 * degree;
  const std::string verdict = printed_angles_verdict(circle_study(solves));
  CHECK(contains(verdict, "Table 8: 58 of the 60 printed angles"));
  CHECK(contains(verdict, "the largest difference is 40 deg"));
  CHECK(contains(verdict, "points with an angle that does not agree: 5, 7."));
  solves.pop_back();
  CHECK(contains(printed_angles_verdict(circle_study(solves)), "55 of the 60"));
  CHECK(contains(printed_angles_verdict(circle_study(solves)), "unsolved points: 1."));
  solves[0].answer_rad[1] = NAN;
  CHECK(contains(printed_angles_verdict(circle_study(solves)), "54 of the 60"));
  CHECK(contains(printed_angles_verdict(circle_study(solves)), "some of our angles are not finite"));
}

TEST_CASE("Table 8 tells of our mean error and of the printed errors' two means", "[circle]") {
  std::vector<SolveRecord> solves = synthetic::dobot_solves();
  for (SolveRecord& solve : solves) solve.position_error_cm = solve.point * 1e-15;  // mean 10.5e-15
  const Table table = *table_8(circle_study(solves));
  CHECK(has_note(table, "The mean of our errors is 1.05e-14 cm."));
  CHECK(has_note(
      table,
      "mean of the printed errors is 2.55e-14 cm; the paper's text says 2.1196e-14 cm. With 9.61e-15 instead of 9.61e-14 cm at point "
      "12 it would be 2.12e-14 cm."));
  solves[3].position_error_cm = HUGE_VAL;
  CHECK(has_note(*table_8(circle_study(solves)), "Some of our answers are not finite"));
}

TEST_CASE("only a circle that claims to be the paper's has a Table 8, and it is not held against Table 3", "[circle]") {
  CHECK(!table_8(circle_study(synthetic::dobot_solves(), R"({"path": {"kind": "circle"}})")));
  CHECK(!table_8(circle_study(synthetic::dobot_solves(), R"({"published": "slim2023", "path": {"kind": "helix"}})")));
  CHECK(!table_8(circle_study(synthetic::dobot_solves(), "no JSON")));
  CHECK(printed_angles_verdict(circle_study(synthetic::dobot_solves(), "{}")).empty());
  for (const Comparison& row : compare(circle_study(synthetic::dobot_solves()))) {
    CHECK(!std::isfinite(row.paper_mean));
  }
}

TEST_CASE("Table 8 of nothing solved, of other numbers of points and joints stands", "[circle]") {
  CHECK(table_8(circle_study({}))->rows.empty());
  CHECK(contains(printed_angles_verdict(circle_study({})), "0 of the 60 printed angles"));
  const Table longer = *table_8(circle_study(synthetic::dobot_solves(23)));
  REQUIRE(longer.rows.size() == 23);
  CHECK(is_empty(longer, 22, "paper_theta1_deg"));
  std::vector<SolveRecord> solves = synthetic::dobot_solves(2);
  solves[0].answer_rad = {};
  solves[1].answer_rad.push_back(0.5);
  const Table others = *table_8(circle_study(solves));
  CHECK(!std::isfinite(number_at(others, 0, "largest_difference_deg")));
  CHECK(number_at(others, 1, "theta4_deg") == Approx(0.5 / degree));  // its own, where the arm has it
}

TEST_CASE("a circle has figures 14 to 18, and every one is drawn", "[circle]") {
  const auto figures = circle_figures(circle_study(synthetic::dobot_solves()));
  CHECK(names_of(figures) == std::vector<std::string>{"figure-14", "figure-15", "figure-16", "figure-17", "figure-18"});
  check_drawn(figures);
  CHECK(contains(figures[0].settings, "set view map"));
  for (const char* arm : {"'arm at point 1'", "'arm at point 8'", "'arm at point 15'"})
    CHECK(contains(figures[1].plot, arm));
  CHECK(contains(figures[1].data, "\n0 0 5.8"));  // the shoulder
  CHECK(contains(figures[2].caption, "the joint limits 90 deg (joint 1), 85 deg (joint 2), 95 deg (joint 3)."));
  CHECK(contains(figures[2].data, "# as printed\n1 34.8 66.5 49.5 34.8\n"));  // the printed Table 8
  CHECK(contains(figures[3].data, "\n12 9.61e-14\n"));
}

TEST_CASE("the drawn circle ends where it began", "[circle]") {
  std::istringstream lines(circle_figures(circle_study(synthetic::dobot_solves())).front().data);
  std::vector<std::string> drawn;
  for (std::string line; std::getline(lines, line) && !line.empty();) drawn.push_back(line);
  REQUIRE(drawn.size() == 1 + 20 + 1);  // the heading, the points, the first again
  CHECK(drawn.back() == drawn[1]);
}

TEST_CASE("joint angles without printed ones are drawn as for any path", "[circle]") {
  const auto figures = circle_figures(circle_study(synthetic::dobot_solves(), R"({"path": {"kind": "circle"}})"));
  CHECK(contains(figures[2].caption, "in the first run of each solver"));
  CHECK(!contains(figures[2].data, "as printed"));
}

TEST_CASE("another path has none of these figures, and no trace no convergence", "[circle]") {
  CHECK(circle_figures(circle_study(synthetic::dobot_solves(), R"({"path": {"kind": "helix"}})")).empty());
  CHECK(circle_figures(circle_study({})).empty());
  std::vector<SolveRecord> solves = synthetic::dobot_solves();
  for (SolveRecord& solve : solves) solve.trace_cm.clear();
  CHECK(circle_figures(circle_study(solves)).size() == 4);
}

TEST_CASE("the convergence is the mean over the solves, one that ended keeps its last error", "[circle]") {
  std::vector<SolveRecord> solves = synthetic::dobot_solves(3);
  solves[0].trace_cm = {8, 4, 1};
  solves[1].trace_cm = {2};
  solves[2].trace_cm = {};
  const Figure figure = circle_figures(circle_study(solves)).back();
  CHECK(contains(figure.data, "# iteration, mean of the best position error [cm]\n1 5\n2 3\n3 1.5\n"));
}

TEST_CASE("the order of rounding is 2^-52 of the farthest target's distance", "[circle]") {
  std::vector<SolveRecord> solves = synthetic::dobot_solves(1);
  solves[0].target_position_m = {0.03, 0.04, 0};  // 5 cm
  const Figure figure = circle_figures(circle_study(solves)).back();
  CHECK(contains(figure.caption, "Dashed: 1.1e-15 cm"));  // 5 / 4503599627370496 = 1.1102e-15
  CHECK(contains(figure.plot, "1.1102230246251565e-15 with lines"));
}

TEST_CASE("figures of a circle are drawn whatever is missing from the study", "[circle]") {
  std::vector<SolveRecord> solves = synthetic::dobot_solves();
  SECTION("a single point") { check_drawn(circle_figures(circle_study(synthetic::dobot_solves(1)))); }
  SECTION("all missed, as far as errors go") {
    for (SolveRecord& solve : solves) {
      solve.position_error_cm = NAN;
      solve.answer_rad.assign(3, NAN);
      solve.reached_position_m.assign(3, NAN);
      solve.trace_cm.assign(5, NAN);
    }
    const auto figures = circle_figures(circle_study(solves));
    CHECK(contains(figures[0].caption, "Some of its answers are not finite."));
    check_drawn(figures);
  }
  SECTION("errors of zero") {
    for (SolveRecord& solve : solves) {
      solve.position_error_cm = 0;
      solve.trace_cm.assign(5, 0);
    }
    check_drawn(circle_figures(circle_study(solves)));
  }
  SECTION("no positions and no angles") {
    for (SolveRecord& solve : solves) {
      solve.target_position_m.clear();
      solve.reached_position_m.clear();
      solve.answer_rad.clear();
    }
    check_drawn(circle_figures(circle_study(solves)));
  }
  SECTION("a definition of the circle alone") {
    check_drawn(circle_figures(circle_study(solves, R"({"path": {"kind": "circle"}})")));
  }
  SECTION("a definition of the wrong types") {
    check_drawn(circle_figures(circle_study(solves, R"({"path": {"kind": "circle", "centre_cm": "x", "radius_cm": []},
        "arm": {"kind": "dobot_magician", "upper_arm_m": [], "lower_deg": [1e308, "a"], "upper_deg": {}}})")));
  }
}
