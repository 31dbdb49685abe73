#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

#include "analysis/figures/of_study.hpp"
#include "results/store.hpp"

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

std::map<std::string, int> line_styles(const std::vector<NamedSolver>& solvers, FigureStyle& style) {
  const std::size_t own_colours = style.palette.size();
  const bool is_short = own_colours < own_palette.size();
  std::map<std::string, std::size_t> places;
  std::vector<std::size_t> users(own_colours);
  const auto give = [&](const std::string& label, std::size_t place) {
    users.resize(style.palette.size());
    if (places.emplace(label, place).second) ++users[place];
  };
  for (const auto& [label, algorithm] : solvers) {
    const auto given = style.colours.find(label);
    if (given != style.colours.end()) give(label, place_in(style.palette, given->second));
  }
  for (const auto& [label, algorithm] : solvers) {
    const auto own = std::ranges::find(own_places, algorithm, [](const auto& place) { return place.first; });
    if (!is_short && own != std::end(own_places) && users[own->second] == 0) give(label, own->second);
  }
  for (const NamedSolver& solver : solvers) {
    const auto rarest = std::min_element(users.begin(), users.begin() + static_cast<std::ptrdiff_t>(own_colours));
    give(solver.label, static_cast<std::size_t>(rarest - users.begin()));
  }
  constexpr std::size_t markers = 13;                      // style.gp
  std::vector<std::pair<std::string, std::size_t>> given;  // by algorithm
  std::map<std::string, int> styles;
  for (const auto& [label, algorithm] : solvers) {
    if (styles.contains(label)) continue;
    // How many have the style, how many variants the marker, and how many others.
    const auto users_of = [&, &own = algorithm](std::size_t i) {
      std::array<int, 3> n{};
      for (const auto& [other, its] : given) {
        n[0] += its == i ? 1 : 0;
        if (its % markers == i % markers) ++n[other == own ? 1 : 2];
      }
      return n;
    };
    std::size_t rarest = places.at(label);
    for (std::size_t i = rarest; i < markers * style.palette.size(); i += style.palette.size()) {
      if (users_of(i) < users_of(rarest)) rarest = i;
    }
    given.emplace_back(algorithm, rarest);
    styles.emplace(label, static_cast<int>(1 + rarest));
  }
  return styles;
}

}  // namespace ikbench::figures
