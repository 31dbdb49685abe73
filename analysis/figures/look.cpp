#include "analysis/figures/look.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "analysis/figures/parts.hpp"
#include "base/names.hpp"

namespace ikbench::figures {

using namespace judge;
using namespace results;

namespace {

// The solvers that have a place in the palette. In most studies of up to seven solvers all places are different.
const std::vector<std::vector<std::string_view>> own_solvers{{"ik_bat"},
                                                             {"bat", "newton"},
                                                             {"differential_evolution", "nlopt"},
                                                             {"particle_swarm"},
                                                             {"k_artificial_bee_colony", "levenberg_marquardt"},
                                                             {"multi_objective_swarm", "damped_least_squares"},
                                                             {"random_search", "kdl_newton"}};

// Returns the place of a colour, which is added if the palette lacks the colour.
std::size_t place_in(std::vector<std::string>& palette, const std::string& colour) {
  const auto is_same = [&](const std::string& other) { return hex_colour(other) == hex_colour(colour); };
  const auto found = std::ranges::find_if(palette, is_same);
  const auto place = static_cast<std::size_t>(found - palette.begin());
  if (found == palette.end()) palette.push_back(colour);
  return place;
}

// Returns whether a figure has a "caption", or a title of the axis "x" or "y".
bool has_part(const Figure& figure, const std::string& part) {
  return part == "caption" || (figure.settings + figure.plot).find(part + "_title") != std::string::npos;
}

// Gives a part of a figure another text. An empty text changes nothing.
void reword(Figure& figure, const std::string& part, const std::string& text) {
  if (text.empty()) return;
  if (part == "caption")
    figure.caption = text;
  else
    figure.titles += fmt::format("{}_title = {}\n", part, gnuplot_text(text));
}

constexpr std::size_t markers = 13;  // as style.gp has them

// The colours of a palette that a solver may get.
struct Colours {
  std::size_t first, end;  // places
  std::size_t all;         // in the palette
};

// Styles that solvers have, each with the algorithm of its solver.
using GivenStyles = std::vector<std::pair<std::string, std::size_t>>;

// Returns the style for a solver with this algorithm. Fewest solvers have the colour of the style. Among such styles
// fewest solvers have this one, then fewest variants of the algorithm have its marker.
std::size_t least_used_style(const GivenStyles& given, const std::string& algorithm, const Colours& colours) {
  std::map<std::array<int, 4>, std::size_t> by_users;
  for (std::size_t i = 0; i < markers * colours.all; ++i) {
    if (i % colours.all < colours.first || i % colours.all >= colours.end) continue;
    std::array<int, 4> users{};
    for (const auto& [other, style] : given) {
      if (style % colours.all == i % colours.all) ++users[0];
      if (style == i) ++users[1];
      if (style % markers == i % markers) ++users[other == algorithm ? 2 : 3];
    }
    by_users.emplace(users, i);
  }
  return by_users.begin()->second;
}

}  // namespace

std::map<std::string, int> line_styles(const std::vector<Series>& solvers, FigureStyle& style) {
  const std::size_t own_colours = style.palette.size();
  for (const auto& [label, colour] : style.colours) place_in(style.palette, colour);
  const std::size_t hues = style.palette.size();
  GivenStyles given;
  std::map<std::string, int> styles;
  // Gives a solver a style with a colour from place `first` to before `end`.
  const auto give = [&](const Series& solver, std::size_t first, std::size_t end) {
    if (styles.contains(solver.label)) return;
    const Colours colours{.first = first, .end = end, .all = hues};
    given.emplace_back(solver.algorithm, least_used_style(given, solver.algorithm, colours));
    styles.emplace(solver.label, static_cast<int>(1 + given.back().second));
  };
  for (const Series& solver : solvers) {
    if (!style.colours.contains(solver.label)) continue;
    const std::size_t place = place_in(style.palette, style.colours.at(solver.label));
    give(solver, place, place + 1);
  }
  // The first solvers share no colour.
  for (const std::size_t n : {std::min(own_colours, solvers.size()), solvers.size()}) {
    for (const Series& solver : std::span(solvers).first(n)) {
      const auto is_of = [&](const auto& solvers_of) { return std::ranges::count(solvers_of, solver.algorithm) > 0; };
      const auto place = static_cast<std::size_t>(std::ranges::find_if(own_solvers, is_of) - own_solvers.begin());
      if (own_colours < default_palette.size() || place == own_solvers.size()) continue;
      const auto has_place = [&](const auto& algorithm_and_place) {
        return algorithm_and_place.second % hues == place;
      };
      if (std::ranges::none_of(given, has_place)) give(solver, place, place + 1);
    }
    for (const Series& solver : std::span(solvers).first(n)) give(solver, 0, own_colours);
  }
  return styles;
}

Look look_of(std::vector<Series> solvers, FigureStyle style) {
  std::ranges::stable_sort(solvers, {}, [&](const Series& solver) {  // solvers that are not shown come last
    return std::ranges::find(style.solvers, solver.label) - style.solvers.begin();
  });
  Look look{.style = std::move(style)};
  look.lines = line_styles(solvers, look.style);
  std::vector<std::string> labels;
  labels.reserve(solvers.size());
  for (const Series& solver : solvers) labels.push_back(solver.label);
  look.names = base::short_names(labels);
  return look;
}

Look look_of(const JudgedStudy& judged, FigureStyle style) {
  const JudgedMetric& deciding = judged.metrics[judged.primary];
  std::vector<Series> solvers = judged.study.series;
  if (!style.solvers.empty()) return look_of(std::move(solvers), std::move(style));
  std::vector<std::string> order, own{judged.study.labels.front(), judged.study.definition.plan.control};
  for (const std::size_t i : display_order(deciding, judged.metrics)) order.push_back(deciding.samples.groups[i].name);
  std::vector<std::string> first = order;
  std::ranges::stable_sort(first, {}, [&](const std::string& solver) { return std::ranges::count(own, solver) == 0; });
  const auto is_among_first = [&](const Series& solver) {
    return std::ranges::find(first, solver.label) - first.begin() < std::ssize(style.palette);
  };
  // The place of a solver in the report decides whether it has a colour of its own, but not the colour.
  std::stable_partition(solvers.begin(), solvers.end(), is_among_first);
  Look look = look_of(std::move(solvers), std::move(style));
  look.style.solvers = std::move(order);
  look.own = std::move(own);
  return look;
}

bool is_meant(const std::string& figure, const std::string& name) {
  return figure == name || figure.starts_with(name + "-");
}

std::vector<std::string> reword(const std::vector<Figure*>& figures, const FigureStyle& style) {
  std::vector<std::string> unused;
  for (const auto& [name, words] : style.words) {
    for (const auto& [part, text] : words) {
      std::set<std::string> other_figures;
      bool is_used = text.empty();
      for (Figure* const figure : figures) {
        if (!has_part(*figure, part)) continue;
        if (is_meant(figure->name, name)) {
          is_used = true;
          reword(*figure, part, text);
        } else {
          other_figures.insert(figure->name);
        }
      }
      if (!is_used)
        unused.push_back(
            fmt::format("words.{}: there is no {}; it is in {}", name, part, fmt::join(other_figures, ", ")));
    }
  }
  return unused;
}

}  // namespace ikbench::figures
