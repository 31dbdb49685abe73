// The figure of a grid of targets: its panels, whose cells are solved, behind another solver, or unsolved.
#include "analysis/figures/map.hpp"

#include "tests/common.hpp"

using namespace ikbench::figures;

namespace ikbench {

namespace {

// Returns a study of a row of three places. A solver is given by its evaluations at each target, 0 where it solves
// none.
judge::JudgedStudy row_study(const std::vector<std::pair<std::string, std::vector<int>>>& solvers, int directions = 1) {
  judge::JudgedStudy judged;
  judge::StudyResults& study = judged.study;
  study.definition.search = results::Search::pose;
  study.definition.stop.tolerance = 1e-5;
  study.definition.points = 3 * directions;
  study.definition.runs = 1;
  study.definition.grid = {.directions = directions,
                           .step = 0.1,
                           .across = {1, 0, 0},
                           .up = {0, 0, 1},
                           .shoulder = {0, 0, 0.2},
                           .reach = 0.3};
  for (int point = 0; point < 3 * directions; ++point) study.grid_places.push_back({0.1 * (point / directions), 0.2});
  for (const auto& [name, evaluations] : solvers) {
    for (std::size_t i = 0; i < evaluations.size(); ++i)
      study.solves.push_back({.point = static_cast<int>(i + 1),
                              .label = static_cast<int>(study.labels.size()),
                              .status = evaluations[i] > 0 ? results::Status::ok : results::Status::tolerance_missed,
                              .counted_by = name == "KDL" ? results::CountedBy::none : results::CountedBy::ikbench,
                              .evaluations = evaluations[i]});
    study.labels.push_back(name);
  }
  judged.targets = judge::solved_targets(study);
  return judged;
}

Look plain_look(const judge::JudgedStudy& judged) {
  Look look;
  for (const std::string& label : judged.study.labels) {
    look.style.solvers.push_back(label);
    look.lines[label] = 1;
    look.names[label] = label;
  }
  return look;
}

}  // namespace

TEST_CASE("a cell of a map is solved, behind another solver, or unsolved by all", "[figures]") {
  const judge::JudgedStudy judged = row_study({{"LM", {12, 300, 0}}, {"KDL", {1, 0, 0}}});
  const std::vector<MapPanel> panels = map_panels(judged, plain_look(judged));
  REQUIRE(panels.size() == 2);
  using State = MapCell::State;
  CHECK(panels[0].solved == 2);
  CHECK((panels[0].cells[0].state == State::solved && panels[0].cells[0].value == 12));
  CHECK((panels[0].cells[1].state == State::solved && panels[0].cells[1].value == 300));
  CHECK((panels[0].cells[2].state == State::unsolved && std::isnan(panels[0].cells[2].value)));
  CHECK((panels[1].cells[0].state == State::solved && std::isnan(panels[1].cells[0].value)));
  CHECK(panels[1].cells[1].state == State::behind);
  CHECK(panels[1].cells[2].state == State::unsolved);
  CHECK(panels[0].cells[1].across == 0.1);
  const Figure figure = map_of(judged, plain_look(judged)).value();
  CHECK_THAT(figure.data, ContainsSubstring("0.1 0.2 2 300\n") && ContainsSubstring("0.1 0.2 1 0\n"));
  CHECK_THAT(figure.plot, ContainsSubstring("2 of 2") && ContainsSubstring("1 of 2"));
}

TEST_CASE("a map of a part of a study says which cells are not solved yet", "[figures]") {
  judge::JudgedStudy judged = row_study({{"LM", {12, 300}}, {"DLS", {7}}});
  judged.study.definition.grid.left_out = 5;
  std::vector<MapPanel> panels = map_panels(judged, plain_look(judged));
  REQUIRE((panels.size() == 2 && panels[1].cells.size() == 2));
  CHECK(panels[1].cells[0].state == MapCell::State::solved);
  CHECK(panels[1].cells[1].state == MapCell::State::missing);  // no cross: DLS was not asked
  const Figure partial = map_of(judged, plain_look(judged)).value();
  CHECK_THAT(partial.data, ContainsSubstring("0.1 0.2 3 0\n"));
  CHECK_THAT(partial.plot, ContainsSubstring("'certainly out of reach, or not solved yet'"));
  CHECK_THAT(partial.caption, ContainsSubstring("Solves are missing"));
  CHECK_THAT(partial.pointer, ContainsSubstring("[7.0,null]"));
  judged = row_study({{"LM", {12, 300, 0}}, {"DLS", {7, 0, 0}}});
  judged.study.definition.grid.left_out = 5;
  const Figure whole = map_of(judged, plain_look(judged)).value();
  CHECK_THAT(whole.plot, ContainsSubstring("'certainly out of reach'") && !ContainsSubstring("not solved yet"));
  CHECK_THAT(whole.caption, !ContainsSubstring("missing"));
  CHECK_THAT(whole.pointer, ContainsSubstring(R"("blank":"certainly out of reach")"));
  judged.study.definition.grid.left_out = 0;
  judged.study.definition.points = 9;
  const Figure unasked = map_of(judged, plain_look(judged)).value();
  CHECK_THAT(unasked.plot, ContainsSubstring("'not solved yet'"));
  CHECK_THAT(unasked.pointer, ContainsSubstring(R"("blank":"not solved yet")"));
}

TEST_CASE("a place where a solver was asked for some directions has no cross", "[figures]") {
  const judge::JudgedStudy judged = row_study({{"LM", {5, 5, 5, 5}}, {"DLS", {5, 5, 5}}}, 2);
  const std::vector<MapPanel> panels = map_panels(judged, plain_look(judged));
  REQUIRE((panels.size() == 2 && panels[1].cells.size() == 2));
  CHECK(panels[1].cells[0].state == MapCell::State::solved);
  CHECK(panels[1].cells[1].state == MapCell::State::missing);
}

TEST_CASE("with several directions a cell of a map counts those that are solved", "[figures]") {
  const judge::JudgedStudy judged = row_study({{"LM", {5, 5, 5, 0, 0, 0}}, {"DLS", {5, 0, 0, 5, 0, 0}}}, 2);
  const std::vector<MapPanel> panels = map_panels(judged, plain_look(judged));
  REQUIRE((panels.size() == 2 && panels[0].cells.size() == 3));
  CHECK(panels[0].cells[0].value == 2);
  CHECK(panels[1].cells[0].value == 1);
  CHECK(panels[1].cells[0].state == MapCell::State::behind);
  CHECK(panels[1].cells[1].state == MapCell::State::solved);
  CHECK(panels[0].solved == 3);
}

TEST_CASE("a map without solved targets has only grey cells, and other studies have no map", "[figures]") {
  judge::JudgedStudy judged = row_study({{"LM", {0, 0, 0}}});
  CHECK(map_of(judged, plain_look(judged)).has_value());
  judged.study.definition.grid = {};
  CHECK(!map_of(judged, plain_look(judged)));
}

}  // namespace ikbench
