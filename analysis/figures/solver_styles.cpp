#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

#include "analysis/figures/of_study.hpp"

namespace ikbench::figures {

using namespace results;

namespace {

// Places in the palette. In most studies of up to seven solvers all places are different.
constexpr std::pair<std::string_view, std::size_t> own_places[]{{"ik_bat", 0},
                                                                {"bat", 1},
                                                                {"differential_evolution", 2},
                                                                {"particle_swarm", 3},
                                                                {"k_artificial_bee_colony", 4},
                                                                {"multi_objective_swarm", 5},
                                                                {"random_search", 6},
                                                                {"damped_least_squares", 5},
                                                                {"newton", 1},
                                                                {"levenberg_marquardt", 4},
                                                                {"kdl_newton", 6},
                                                                {"nlopt", 2}};

// The place of a colour, which is added if the palette lacks it.
std::size_t place_in(std::vector<std::string>& palette, const std::string& colour) {
  const auto is_same = [&](const std::string& other) { return hex_colour(other) == hex_colour(colour); };
  const auto found = std::ranges::find_if(palette, is_same);
  const auto place = static_cast<std::size_t>(found - palette.begin());
  if (found == palette.end()) palette.push_back(colour);
  return place;
}

}  // namespace

std::map<std::string, int> line_styles(const std::vector<Series>& solvers, FigureStyle& style) {
  constexpr std::size_t markers = 13;  // style.gp
  const std::size_t own_colours = style.palette.size();
  for (const auto& [label, colour] : style.colours) place_in(style.palette, colour);
  const std::size_t hues = style.palette.size();
  std::vector<std::pair<std::string, std::size_t>> given;  // by algorithm
  std::map<std::string, int> styles;
  // Gives one of these places that fewest have, then the style that fewest have, whose marker fewest variants have.
  const auto give = [&](const Series& solver, std::size_t from, std::size_t to) {
    if (styles.contains(solver.label)) return;
    std::map<std::array<int, 4>, std::size_t> by_users;
    for (std::size_t i = 0; i < markers * hues; ++i) {
      if (i % hues < from || i % hues >= to) continue;
      std::array<int, 4> users{};
      for (const auto& [algorithm, its] : given) {
        if (its % hues == i % hues) ++users[0];
        if (its == i) ++users[1];
        if (its % markers == i % markers) ++users[algorithm == solver.algorithm ? 2 : 3];
      }
      by_users.emplace(users, i);
    }
    given.emplace_back(solver.algorithm, by_users.begin()->second);
    styles.emplace(solver.label, static_cast<int>(1 + given.back().second));
  };
  for (const Series& solver : solvers) {
    if (!style.colours.contains(solver.label)) continue;
    const std::size_t place = place_in(style.palette, style.colours.at(solver.label));
    give(solver, place, place + 1);
  }
  for (const std::size_t n : {std::min(own_colours, solvers.size()), solvers.size()}) {  // the first share no colour
    for (const Series& solver : std::span(solvers).first(n)) {
      const auto own = std::ranges::find(own_places, solver.algorithm, [](const auto& place) { return place.first; });
      if (own_colours < own_palette.size() || own == std::end(own_places)) continue;
      const auto has_it = [&](const auto& other) { return other.second % hues == own->second; };
      if (std::ranges::none_of(given, has_it)) give(solver, own->second, own->second + 1);
    }
    for (const Series& solver : std::span(solvers).first(n)) give(solver, 0, own_colours);
  }
  return styles;
}

}  // namespace ikbench::figures
