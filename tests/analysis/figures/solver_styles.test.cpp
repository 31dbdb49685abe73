// The colours of solvers: the same in every report, and no two looks alike.
#include "analysis/figures/solver_styles.hpp"

#include <set>
#include <string>
#include <vector>

#include "experiments/study_reader.hpp"
#include "results/store.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::figures;
using namespace ikbench::results;

namespace {

std::string colour_in(const std::vector<NamedSolver>& solvers, const std::string& label, FigureStyle style = {}) {
  const auto styles = line_styles(solvers, style);
  return colour_of(styles.at(label), style);
}

}  // namespace

TEST_CASE("a built-in solver has one colour in every study, whatever its label and place", "[figure]") {
  const std::vector<NamedSolver> alone{{"IK-BA", "ik_bat"}},
      last{{"x", "x"}, {"DE", "differential_evolution"}, {"bats", "ik_bat"}};
  CHECK(colour_in(alone, "IK-BA") == "#1E8CF8");
  CHECK(colour_in(last, "bats") == "#1E8CF8");
  for (const std::string name :
       {"bat", "particle_swarm", "damped_least_squares", "newton", "kdl_lma", "nlopt", "pagmo"}) {
    CAPTURE(name);
    const std::vector<NamedSolver> first{{"a", name}}, second{{"b", "unknown"}, {"c", name}};
    CHECK(colour_in(first, "a") == colour_in(second, "c"));
  }
}

TEST_CASE("no two solvers of a study look alike, and other solvers have other colours while there are any",
          "[figure]") {
  for (const experiments::Study& study : experiments::studies()) {
    CAPTURE(study.name);
    std::vector<NamedSolver> solvers{{"mine", "unknown"}};
    for (const experiments::SolverEntry& entry : study.solvers) solvers.push_back({entry.label, entry.solver});
    FigureStyle style;
    std::set<int> looks;
    for (const auto& [label, look] : line_styles(solvers, style)) looks.insert(look);
    CHECK(looks.size() == solvers.size());
  }
  const std::vector<NamedSolver> solvers{{"a", "x"}, {"IK-BA", "ik_bat"}, {"b", "y"}, {"DE", "differential_evolution"}};
  FigureStyle style;
  std::set<std::string> colours;
  for (const auto& [label, look] : line_styles(solvers, style)) colours.insert(colour_of(look, style));
  CHECK(colours.size() == 4);
}

TEST_CASE("variants of a solver have its colour, its shade and other line types", "[figure]") {
  const std::vector<NamedSolver> solvers{{"IK-BA", "ik_bat"}, {"clamped", "ik_bat"}, {"small", "ik_bat"}};
  FigureStyle style;
  const auto styles = line_styles(solvers, style);
  CHECK(styles.at("IK-BA") == 1);
  CHECK(styles.at("clamped") == 8);
  CHECK(styles.at("small") == 15);
  CHECK(colour_of(8, style) == colours_and_shades(style).at(7));
}

TEST_CASE("entries of one program have one colour, and imports have colours of their own", "[figure]") {
  FigureStyle style;
  const auto styles = line_styles({{"mine w=1", "mine"}, {"other", "other"}, {"mine w=2", "mine"}}, style);
  CHECK(styles.at("mine w=2") == styles.at("mine w=1") + 7);
  CHECK(styles.at("other") % 7 != styles.at("mine w=1") % 7);
  const std::string imported(imported_algorithm);
  const auto of_imports = line_styles({{"a", imported}, {"b", imported}}, style);
  CHECK(of_imports.at("a") % 7 != of_imports.at("b") % 7);
}

TEST_CASE("chosen solvers have the colours of a short palette in their order", "[figure]") {
  FigureStyle three{.palette = {"#0072B2", "red", "olive"}};
  const std::vector<NamedSolver> solvers{{"IK-BA", "ik_bat", true},
                                         {"PSO", "particle_swarm", true},
                                         {"DE", "differential_evolution", true},
                                         {"BA", "bat"},
                                         {"K-ABC", "x"}};
  const auto styles = line_styles(solvers, three);
  CHECK(styles.at("IK-BA") == 1);
  CHECK(styles.at("PSO") == 2);
  CHECK(styles.at("DE") == 3);
  CHECK(styles.size() == 5);
}

TEST_CASE("a colour of a study goes before the solver's own", "[figure]") {
  FigureStyle style{.colours = {{"IK-BA", "#abcdef"}, {"mine", "blue"}}};
  const std::vector<NamedSolver> solvers{{"IK-BA", "ik_bat"}, {"mine", "x"}, {"IK-BA 2", "ik_bat"}};
  const auto styles = line_styles(solvers, style);
  CHECK(colour_of(styles.at("IK-BA"), style) == "#ABCDEF");
  CHECK(colour_of(styles.at("mine"), style) == "#1E8CF8");
  CHECK(style.palette.size() == 8);
  FigureStyle two{.palette = {"black", "#FF0000"}};
  std::set<int> looks;
  for (const auto& [label, look] : line_styles({{"a", "bat"}, {"b", "newton"}, {"c", "x"}, {"d", "y"}}, two))
    looks.insert(look);
  CHECK(looks.size() == 4);
  FigureStyle three{.palette = {"blue", "red", "green"}};
  std::set<std::string> colours;
  for (const auto& [label, look] : line_styles({{"a", "ik_bat"}, {"b", "particle_swarm"}, {"c", "bat"}}, three))
    colours.insert(colour_of(look, three));
  CHECK(colours.size() == 3);
}
