// Table 8 and the figures of the Dobot's circle.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "analysis/inference/make_study.hpp"
#include "analysis/slim2023/paper_figures.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/analysis/drawn.hpp"
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
  CHECK(drawn_as_svg(figures, folder.path / "figures") == "");
  for (const std::string& file : files_in(folder.path)) {
    CAPTURE(file);
    CHECK((file == "figures/style.gp" || file.starts_with("figures/figure-")));
  }
}

}  // namespace

TEST_CASE("angles by the closed form are the 80 printed ones of Table 8", "[circle]") {
  const Table table = *table_8(circle_study(synthetic::dobot_solves()));
  REQUIRE(table.rows.size() == 20);
  CHECK(readable(cell_at(table, 0, "theta2_deg")).ends_with(" (printed 66.5)"));  // the printed Table 8
  CHECK(readable(cell_at(table, 11, "error_cm")).ends_with(" (printed 9.61e-14)"));
  CHECK(has_note(table, "80 of the 80 printed angles agree with ours"));
  CHECK(has_note(table, "fitted them to the angles of this table"));
}

TEST_CASE("printed angles that do not agree are counted and coloured", "[circle]") {
  std::vector<SolveRecord> solves = synthetic::dobot_solves();
  solves[4].answer_rad[0] += 0.2 * degree;  // theta1
  solves[6].answer_rad[2] -= 40 * degree;
  const Table table = *table_8(circle_study(solves));
  CHECK(has_note(table, "77 of the 80 printed angles"));
  CHECK(std::get<OursAndPrinted>(cell_at(table, 4, "theta1_deg")).nearness == Nearness::far);
  CHECK(std::get<OursAndPrinted>(cell_at(table, 4, "theta2_deg")).nearness == Nearness::within);
  solves.pop_back();
  solves[0].answer_rad[1] = NAN;
  CHECK(has_note(*table_8(circle_study(solves)), "72 of the 80"));
}

TEST_CASE("only a circle that claims to be the paper's has a Table 8, and it is not held against Table 3", "[circle]") {
  CHECK(!table_8(circle_study(synthetic::dobot_solves(), R"({"path": {"kind": "circle"}})")));
  CHECK(!table_8(circle_study(synthetic::dobot_solves(), R"({"published": "slim2023", "path": {"kind": "helix"}})")));
  CHECK(!table_8(circle_study(synthetic::dobot_solves(), "no JSON")));
  CHECK(printed_table_3(circle_study(synthetic::dobot_solves()), Metric::position_error_cm).empty());
}

TEST_CASE("Table 8 of nothing solved, of other numbers of points and joints stands", "[circle]") {
  CHECK(table_8(circle_study({}))->rows.empty());
  CHECK(has_note(*table_8(circle_study({})), "0 of the 80 printed angles"));
  const Table longer = *table_8(circle_study(synthetic::dobot_solves(23)));
  REQUIRE(longer.rows.size() == 23);
  CHECK(std::holds_alternative<double>(cell_at(longer, 22, "theta1_deg")));
  std::vector<SolveRecord> solves = synthetic::dobot_solves(2);
  solves[0].answer_rad = {};
  CHECK(!std::isfinite(number_at(*table_8(circle_study(solves)), 0, "theta1_deg")));
}

TEST_CASE("a circle has figures 14 to 18, and every one is drawn", "[circle]") {
  const auto figures = circle_figures(circle_study(synthetic::dobot_solves()));
  CHECK(names_of(figures) == std::vector<std::string>{"figure-14", "figure-15", "figure-16", "figure-17", "figure-18"});
  check_drawn(figures);
  CHECK(contains(figures[0].settings, "set view map"));
  for (const char* arm : {"'arm at point 1'", "'arm at point 8'", "'arm at point 15'"})
    CHECK(contains(figures[1].plot, arm));
  CHECK(contains(figures[1].data, "\n0 0 5.8"));  // the shoulder
  CHECK(contains(figures[2].caption, "in the first run of each solver"));
  CHECK(contains(figures[3].data, "\n12 9.61e-14\n"));
}

TEST_CASE("the drawn circle ends where it began", "[circle]") {
  std::istringstream lines(circle_figures(circle_study(synthetic::dobot_solves())).front().data);
  std::vector<std::string> drawn;
  for (std::string line; std::getline(lines, line) && !line.empty();) drawn.push_back(line);
  REQUIRE(drawn.size() == 1 + 20 + 1);  // the heading, the points, the first again
  CHECK(drawn.back() == drawn[1]);
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
