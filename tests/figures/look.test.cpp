// The colours of solvers: the same in every report, and no two looks alike.
#include "tests/figures/drawn.hpp"

namespace {

// The colour of a line style, as style.gp finds it.
std::string colour_of(int line_style, const FigureStyle& style) {
  return hex_colour(style.palette[static_cast<std::size_t>(line_style - 1) % style.palette.size()]).value();
}

std::string colour_in(const std::vector<Series>& solvers, const std::string& label, FigureStyle style = {}) {
  const auto styles = line_styles(solvers, style);
  return colour_of(styles.at(label), style);
}

// How many looks, and which colours, solvers have.
std::pair<std::size_t, std::set<std::string>> looks_of(const std::vector<Series>& solvers, FigureStyle style = {}) {
  std::set<int> looks;
  std::set<std::string> colours;
  for (const auto& [label, look] : line_styles(solvers, style)) looks.insert(look);
  for (const int look : looks) colours.insert(colour_of(look, style));
  return {looks.size(), colours};
}

// WCAG 2.1, "relative luminance" and "contrast ratio".
double linear(std::string_view colour, std::size_t i) {
  const double c = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(std::string_view colour) {
  return 0.2126 * linear(colour, 0) + 0.7152 * linear(colour, 1) + 0.0722 * linear(colour, 2);
}

double contrast(std::string_view a, std::string_view b) {
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

// CIE 1976 L*a*b* of an sRGB colour, white D65.
std::array<double, 3> lab(std::string_view colour) {
  std::array<double, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) rgb[i] = linear(colour, i);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.95047),
               y = f(0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2]),
               z = f((0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(std::string_view a, std::string_view b) {
  const auto one = lab(a), other = lab(b);
  return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

}  // namespace

TEST_CASE("a built-in solver has one colour in every study, whatever its label and place", "[figure]") {
  const std::vector<Series> alone{{"", "IK-BA", "ik_bat"}},
      last{{"", "x", "x"}, {"", "DE", "differential_evolution"}, {"", "bats", "ik_bat"}};
  CHECK(colour_in(alone, "IK-BA") == default_palette[0]);
  CHECK(colour_in(last, "bats") == default_palette[0]);
  for (const std::string name : {"bat", "particle_swarm", "damped_least_squares", "newton", "kdl_newton", "nlopt"}) {
    CAPTURE(name);
    const std::vector<Series> first{{"", "a", name}}, second{{"", "b", "unknown"}, {"", "c", name}};
    CHECK(colour_in(first, "a") == colour_in(second, "c"));
  }
}

TEST_CASE("no two solvers of a study look alike, and other solvers have other colours while there are any",
          "[figure]") {
  for (const experiments::Study& study : experiments::built_in_studies()) {
    CAPTURE(study.name);
    std::vector<Series> solvers{{"", "mine", "unknown"}};
    for (const experiments::SolverEntry& entry : study.solvers) solvers.push_back({"", entry.label, entry.solver});
    CHECK(looks_of(solvers).first == solvers.size());
  }
  const std::vector<Series> solvers{
      {"", "a", "x"}, {"", "IK-BA", "ik_bat"}, {"", "b", "y"}, {"", "DE", "differential_evolution"}};
  CHECK(looks_of(solvers).second.size() == 4);
}

TEST_CASE("variants of a solver have other colours while there are any, then other line types and markers",
          "[figure]") {
  std::vector<Series> solvers;
  for (const std::string name : {"ik_bat", "mine"}) {
    for (const char variant : std::string("abcdefgh")) solvers.push_back({"", name + variant, name});
    FigureStyle style;
    const auto styles = line_styles(solvers, style);
    CHECK(styles.at("ik_bata") == 1);
    std::set<int> looks, markers;
    std::map<std::string, int> users;
    for (const auto& [label, look] : styles) {
      looks.insert(look), ++users[colour_of(look, style)];
      if (label.starts_with(name)) markers.insert((look - 1) % 13);
    }
    CHECK(looks.size() == solvers.size());
    CHECK(markers.size() == 8);
    CHECK(users.size() == 7);
    for (const auto& [colour, n] : users) CHECK(n <= 1 + static_cast<int>(solvers.size()) / 7);
    solvers.resize(8);
  }
  std::set<std::string> of_first;  // seven; built-in solvers after them take no colour away
  for (const char* name : {"bat", "newton", "nlopt", "differential_evolution"}) solvers.push_back({"", name, name});
  FigureStyle style;
  const auto styles = line_styles(solvers, style);
  for (std::size_t i = 0; i < 7; ++i) of_first.insert(colour_of(styles.at(solvers[i].label), style));
  CHECK(of_first.size() == 7);
}

TEST_CASE("solvers have the colours of a short palette in their order", "[figure]") {
  FigureStyle three{.palette = {"#0072B2", "#8D1804", "#9C8602"}};
  const auto styles =
      line_styles({{"", "IK-BA", "ik_bat"}, {"", "PSO", "particle_swarm"}, {"", "DE", "x"}, {"", "BA", "bat"}}, three);
  CHECK(styles == std::map<std::string, int>{{"IK-BA", 1}, {"PSO", 2}, {"DE", 3}, {"BA", 4}});
}

TEST_CASE("a colour of a study goes before the solver's own", "[figure]") {
  FigureStyle style{.colours = {{"IK-BA", "#abcdef"}, {"mine", "#267195"}}};
  const std::vector<Series> solvers{{"", "IK-BA", "ik_bat"}, {"", "mine", "x"}, {"", "IK-BA 2", "ik_bat"}};
  const auto styles = line_styles(solvers, style);
  CHECK(colour_of(styles.at("IK-BA"), style) == "#ABCDEF");
  CHECK(colour_of(styles.at("mine"), style) == "#267195");
  CHECK(style.palette.size() == 8);
  const FigureStyle two{.palette = {"#000000", "#FF0000"}}, three{.palette = {"#1E8CF8", "#8D1804", "#00705B"}};
  CHECK(looks_of({{"", "a", "bat"}, {"", "b", "newton"}, {"", "c", "x"}, {"", "d", "y"}}, two).first == 4);
  CHECK(looks_of({{"", "a", "ik_bat"}, {"", "b", "particle_swarm"}, {"", "c", "bat"}}, three).second.size() == 3);
}

TEST_CASE("every series has a contrast of at least 3 on paper", "[figure]") {
  CHECK(contrast("#FFFFFF", "#000000") == Approx(21));
  CHECK(contrast("#777777", "#FFFFFF") == Approx(4.48).margin(0.005));  // WebAIM's contrast checker
  CHECK(contrast("#E69F00", "#FFFFFF") < 3);                            // what was too pale
  for (const std::string& colour : default_palette) CHECK(contrast(colour, "#FFFFFF") >= 3);
}

TEST_CASE("any two series are farther apart than two blues were that readers took for one", "[figure]") {
  CHECK(lab("#FF0000")[0] == Approx(53.24).margin(0.01));  // Lindbloom's calculator: 53.24, 80.09, 67.20
  CHECK(lab("#FF0000")[1] == Approx(80.09).margin(0.01));
  CHECK(lab("#FF0000")[2] == Approx(67.20).margin(0.01));
  CHECK(distance("#0E65B8", "#3793CD") == Approx(25.8).margin(0.01));
  for (std::size_t i = 0; i < default_palette.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(default_palette[i], default_palette[j]);
      CHECK(distance(default_palette[i], default_palette[j]) > 30);
      CHECK(std::abs(lab(default_palette[i])[0] - lab(default_palette[j])[0]) > 7.5);  // greys of a printed copy
    }
  }
}
