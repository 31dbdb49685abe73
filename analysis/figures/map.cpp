#include "analysis/figures/map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/figures/parts.hpp"
#include "analysis/figures/plots.hpp"
#include "analysis/figures/rows.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::figures {

using namespace judge;
using base::text_of;
using results::TargetGrid;

namespace {

constexpr std::size_t most_panels = 24;
constexpr std::size_t most_svg_cells = 30'000;  // of all panels; an SVG takes 110 bytes per cell
// The sizes of the parts of the figure [cm], with text of 8 pt.
constexpr double left_cm = 1.35, right_cm = 0.25, between_cm = 0.45, head_cm = 0.85, ticks_cm = 0.5, title_cm = 0.45;
constexpr double bar_cm = 1.1, entry_cm = 0.36, narrow_cm = 12;

constexpr double dot_share = 0.35;  // side of a dot, as a share of the side of its cell

// The targets of one place of the grid, which follow one another.
struct MapPlace {
  double across, up;       // [m]
  std::size_t begin, end;  // indices of targets
};

std::vector<MapPlace> places_of(const JudgedStudy& judged) {
  std::vector<MapPlace> places;
  const std::vector<SolvedTarget>& targets = judged.targets.targets;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto [across, up] = judged.study.grid_places.at(static_cast<std::size_t>(targets[i].point - 1));
    const double step = judged.study.definition.grid.step;
    const bool is_new = places.empty() || std::hypot(across - places.back().across, up - places.back().up) > step / 2;
    if (is_new) places.push_back({across, up, i, i});
    ++places.back().end;
  }
  return places;
}

// Returns how many targets of a place a solver solves.
std::size_t solved_at(const SolvedTargets& targets, const MapPlace& place, std::size_t solver) {
  std::size_t count = 0;
  for (std::size_t target = place.begin; target < place.end; ++target) count += targets.solves(solver, target);
  return count;
}

// Returns whether a solver lacks solves of a place. `solves` has the number of its solves by point.
bool lacks_solves(const JudgedStudy& judged, const MapPlace& place, const std::vector<int>& solves) {
  for (std::size_t target = place.begin; target < place.end; ++target)
    if (solves[static_cast<std::size_t>(judged.targets.targets[target].point - 1)] < judged.study.definition.runs)
      return true;
  return false;
}

// Returns the number of a solver's solves by point.
std::vector<int> solves_of(const StudyResults& study, const std::string& solver) {
  std::vector<int> solves(study.grid_places.size(), 0);
  for (const SolveSummary& solve : study.of(solver))
    if (const auto place = static_cast<std::size_t>(solve.point - 1); place < solves.size()) ++solves[place];
  return solves;
}

// Returns the evaluations of a solver by point; NaN if they are not counted.
std::vector<double> evaluations_of(const StudyResults& study, const std::string& solver) {
  std::vector<double> evaluations(study.grid_places.size(), nowhere);
  for (const SolveSummary& solve : study.of(solver)) {
    const auto place = static_cast<std::size_t>(solve.point - 1);
    if (solve.counted_by != results::CountedBy::none && solve.evaluations > 0 && place < evaluations.size())
      evaluations[place] = static_cast<double>(solve.evaluations);
  }
  return evaluations;
}

// `most` has the most targets that any solver solves at each place.
MapPanel panel_of(const JudgedStudy& judged, const std::vector<MapPlace>& places, const std::vector<std::size_t>& most,
                  std::size_t solver) {
  const SolvedTargets& targets = judged.targets;
  const bool has_directions = judged.study.definition.grid.directions > 1;
  const std::vector<double> evaluations = evaluations_of(judged.study, targets.solvers[solver]);
  const std::vector<int> solves = solves_of(judged.study, targets.solvers[solver]);
  MapPanel panel;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const MapPlace& place = places[i];
    MapCell& cell = panel.cells.emplace_back(MapCell{.across = place.across, .up = place.up, .value = nowhere});
    const std::size_t solved = solved_at(targets, place, solver);
    panel.solved += solved;
    // A solver is behind only if it was asked for all directions of the place.
    const bool may_catch_up = solved == 0 || solved < most[i];
    if (may_catch_up && lacks_solves(judged, place, solves))
      cell.state = MapCell::State::missing;
    else if (most[i] > 0)
      cell.state = solved < most[i] ? MapCell::State::behind : MapCell::State::solved;
    if (solved == 0 || cell.state == MapCell::State::missing) continue;
    const auto point = static_cast<std::size_t>(targets.targets[place.begin].point);
    cell.value = has_directions ? static_cast<double>(solved) : evaluations[point - 1];
  }
  return panel;
}

// The kinds of cells that the panels have, and the ends of the colours.
struct MapKinds {
  bool are_behind = false, are_unsolved = false, are_uncounted = false, are_missing = false;
  bool is_partial = false;  // solves are missing
  // Places without a cell, within the dashed circle: certainly out of reach, or not asked of any solver yet.
  bool are_left_out = false, are_not_asked = false;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;  // values

  bool has_values() const { return largest > 0; }
  // Returns what a place without a cell means; empty if there is none.
  std::string blank_words() const {
    if (are_left_out && are_not_asked) return "certainly out of reach, or not solved yet";
    if (are_left_out) return "certainly out of reach";
    return are_not_asked ? "not solved yet" : "";
  }
};

// Returns whether no solver was asked for some of the targets yet.
bool lacks_targets(const JudgedStudy& judged) {
  return std::ssize(judged.targets.targets) < judged.study.definition.points;
}

MapKinds kinds_of(const JudgedStudy& judged, const std::vector<MapPanel>& panels) {
  const results::StudyDefinition& definition = judged.study.definition;
  MapKinds kinds{.is_partial = !judged.targets.is_complete,
                 .are_left_out = definition.grid.left_out > 0,
                 .are_not_asked = lacks_targets(judged)};
  for (const MapPanel& panel : panels) {
    for (const MapCell& cell : panel.cells) {
      kinds.are_behind |= cell.state == MapCell::State::behind;
      kinds.are_unsolved |= cell.state == MapCell::State::unsolved;
      kinds.are_missing |= cell.state == MapCell::State::missing;
      kinds.are_uncounted |= cell.state == MapCell::State::solved && std::isnan(cell.value);
      kinds.smallest = std::fmin(kinds.smallest, cell.value);
      kinds.largest = std::fmax(kinds.largest, cell.value);
    }
  }
  return kinds;
}

// Returns the numbers of the figure: a block per panel. An uncounted value is 0.
std::string data_of(const std::vector<MapPanel>& panels) {
  std::string data =
      "# place in the plane [m]; 0 unsolved, 1 another solver solves more, 2 solved, 3 not solved yet; value, 0: none\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    data += fmt::format("{}# {}\n", i == 0 ? "" : "\n\n", base::one_line(panels[i].label));
    for (const MapCell& cell : panels[i].cells)
      data +=
          data_row({cell.across, cell.up, static_cast<double>(cell.state), std::isnan(cell.value) ? 0 : cell.value});
  }
  return data;
}

// Returns the settings of the colours: cividis, from few to many. Its lightness falls evenly, also without colours. On
// a dark background its darkest quarter would not be seen.
std::string colours_of(const MapKinds& kinds, const TargetGrid& grid) {
  std::string text =
      "light_to_dark = \"0 '#D9C34F', 1 '#C3B369', 2 '#A59C74', 3 '#8A8678', 4 '#707173', 5 '#575D6D', 6 '#3B496C'\"\n"
      "if (!dark) light_to_dark = light_to_dark . \", 7 '#123570', 8 '#00224E'\"\n"
      "set palette defined (@light_to_dark)\n";
  if (grid.directions > 1)
    return text + fmt::format("set cbrange [1:{0}]\nset cbtics 1\ncolour(v) = v\n", grid.directions);
  if (!kinds.has_values()) return text + "colour(v) = v\n";
  const double low = std::log10(kinds.smallest), high = std::max(low + 0.1, std::log10(kinds.largest));
  std::vector<std::string> ticks;
  for (double decade = std::floor(low); decade <= high; ++decade) {
    for (const double digit : {1.0, 3.0}) {
      const double at = decade + std::log10(digit);
      if (at >= low - 1e-9 && at <= high + 1e-9)
        ticks.push_back(fmt::format("'{:g}' {}", digit * std::pow(10, decade), text_of(at)));
    }
  }
  return text + fmt::format("set cbrange [{}:{}]\nset cbtics ({})\ncolour(v) = log10(v)\n", text_of(low), text_of(high),
                            fmt::join(ticks, ", "));
}

// The places of the panels on the paper. Lengths [cm] are those of a style with text of 8 pt.
struct MapLayout {
  std::size_t columns, rows;
  double panel_cm;   // side of a panel
  double legend_cm;  // below the panels

  double below_cm(std::size_t row) const {  // the bottom of a row of panels, above the bottom of the figure
    return legend_cm + title_cm + ticks_cm + static_cast<double>(rows - 1 - row) * (panel_cm + head_cm + ticks_cm);
  }
  double left_cm_of(std::size_t panel) const {
    return left_cm + static_cast<double>(panel % columns) * (panel_cm + between_cm);
  }
  double height_cm() const { return below_cm(0) + panel_cm + head_cm; }
};

double map_width_cm(std::size_t panels, const results::FigureStyle& style) {
  if (style.width_cm > 0) return style.width_cm;
  if (panels == 1) return 8.5;
  return panels == 2 ? narrow_cm : 17.5;
}

// Returns the largest panels that the width of the figure and the height of the style leave room for.
MapLayout layout_of(std::size_t panels, double width_cm, double legend_cm, const results::FigureStyle& style) {
  const double paper_scale = 8 / style.text_pt;
  const std::size_t columns = std::min<std::size_t>(panels, width_cm < narrow_cm ? 2 : 4);
  MapLayout layout{.columns = columns, .rows = (panels + columns - 1) / columns, .panel_cm = 0, .legend_cm = legend_cm};
  const double across_cm = width_cm * paper_scale - left_cm - right_cm - between_cm * static_cast<double>(columns - 1);
  double panel_cm = across_cm / static_cast<double>(columns);
  if (style.height_cm > 0)
    panel_cm =
        std::min(panel_cm, (style.height_cm * paper_scale - layout.height_cm()) / static_cast<double>(layout.rows));
  layout.panel_cm = std::max(1.0, panel_cm);
  return layout;
}

// Returns the height of a row of the legend above the bottom of the figure. Row 0 is the lowest.
std::string legend_height(std::size_t row) {
  return fmt::format("screen up({})", text_of(0.3 + entry_cm * static_cast<double>(row)));
}

// Returns the command that draws a square of the legend, whose side is a share of the usual one.
std::string legend_square(std::size_t row, std::string_view colour, double share = 1) {
  return fmt::format(
      "set object rectangle center screen margin(1.6), {} size screen margin({}), screen up({}) fc rgb {} fs solid "
      "border lc rgb ink lw 0.3\n",
      legend_height(row), text_of(0.3 * share), text_of(0.24 * share), colour);
}

std::string legend_cross(std::size_t row) {
  return fmt::format("set label '' at screen margin(1.6), {} point pt 2 ps 0.5 lw 0.8 lc rgb ink\n",
                     legend_height(row));
}

std::string legend_words(std::size_t row, std::string_view words) {
  return fmt::format("set label '{}' at screen margin(1.95), {} left tc rgb ink\n", words, legend_height(row));
}

// Returns the legend below the panels.
std::string legend_of(const MapKinds& kinds, bool has_directions) {
  std::vector<std::string> entries;  // from the lowest row
  const auto row = [&] { return entries.size(); };
  if (const std::string words = kinds.blank_words(); !words.empty())
    entries.push_back(legend_square(row(), "paper") + legend_words(row(), words));
  if (kinds.are_unsolved)
    entries.push_back(legend_square(row(), "unsolved") +
                      legend_words(row(), kinds.is_partial ? "no solver solves it so far" : "no solver solves it"));
  if (kinds.are_missing)
    entries.push_back(legend_square(row(), "ink", dot_share) + legend_words(row(), "not solved yet by this solver"));
  if (kinds.are_uncounted)
    entries.push_back(legend_square(row(), "uncounted") + legend_words(row(), "solved, evaluations not counted"));
  if (kinds.are_behind)
    entries.push_back(legend_cross(row()) +
                      legend_words(row(), has_directions ? "another solver solves more" : "another solver solves it"));
  return fmt::format("{}", fmt::join(entries, ""));
}

double legend_cm_of(const MapKinds& kinds) {
  const int entries = int{kinds.are_unsolved} + int{kinds.are_missing} + int{kinds.are_uncounted} +
                      int{kinds.are_behind} + int{!kinds.blank_words().empty()};
  return 0.2 + entry_cm * entries + (kinds.has_values() ? bar_cm : 0);
}

// Returns the settings of the bar of colours, which is drawn with the first panel that has values.
std::string bar_of(const MapLayout& layout, double legend_cm, bool has_directions) {
  constexpr double height_cm = 0.25, place_cm = 1.65;
  const double words_cm = has_directions ? 3.4 : 1.8;
  const double panels_cm = (layout.panel_cm + between_cm) * static_cast<double>(layout.columns) - between_cm;
  const double width_cm = std::clamp(left_cm + panels_cm + right_cm - place_cm - words_cm, 1.5, 4.5);
  return fmt::format(
      "set colorbox horizontal user origin screen margin(1.45), screen up({0}) size screen margin({1}), screen up({2})\n"
      "set cbtics scale 0.4 offset 0, 0.4 textcolor rgb ink\n"
      "set label '{3}' at screen margin({4}), screen up({5}) left tc rgb ink\n",
      text_of(legend_cm - 0.45), text_of(width_cm), text_of(height_cm),
      has_directions ? "tool directions solved" : "evaluations", text_of(place_cm + width_cm),
      text_of(legend_cm - 0.45 + height_cm / 2));
}

// Returns the plot of a panel, whose numbers are block `index`. `half` is half the side of a cell [m].
std::string panel_plot(std::size_t index, double half) {
  constexpr double overlap = 1.08;  // otherwise seams show between cells
  const std::string block = fmt::format("data index {} using 1:", index), size = text_of(overlap * half);
  const auto cells = [&](const char* where, const std::string& colour) {
    return fmt::format("{}({} ? $2 : NaN):({}):({}){} ", block, where, size, size, colour);
  };
  const std::string dot = text_of(dot_share * half);
  const auto crosses = [&](const char* look) {
    const std::string arm = text_of(0.62 * half), arm_twice = text_of(1.24 * half);
    return fmt::format(
        "data index {0} using ($1-{1}):($3 == 1 ? $2-{1} : NaN):({2}):({2}) with vectors nohead {3}, \\\n  data index {0} "
        "using ($1-{1}):($3 == 1 ? $2+{1} : NaN):({2}):(-{2}) with vectors nohead {3}",
        index, arm, arm_twice, look);
  };
  return plotted({cells("$3 == 0", "") + "with boxxyerror fs solid noborder fc rgb unsolved",
                  cells("$3 == 2 && $4 == 0", "") + "with boxxyerror fs solid noborder fc rgb uncounted",
                  cells("$4 > 0", ":(colour($4))") + "with boxxyerror fs solid noborder fc palette",
                  fmt::format("{0}($3 == 3 ? $2 : NaN):({1}):({1}) with boxxyerror fs solid noborder fc rgb ink", block,
                              dot),
                  crosses("lw 1.1 lc rgb paper"), crosses("lw 0.45 lc rgb ink"),
                  "'+' using (shoulder_x):(shoulder_y) every ::0::0 with points pt 1 ps 0.9 lw 2.4 lc rgb paper",
                  "'+' using (shoulder_x):(shoulder_y) every ::0::0 with points pt 1 ps 0.8 lw 1 lc rgb ink"}) +
         '\n';
}

// Returns the commands of one panel. `counted` is the number of targets that any solver solves; of all targets if no
// solver solves any.
std::string panel_commands(const MapPanel& panel, std::size_t index, const MapLayout& layout, std::size_t counted) {
  const std::size_t column = index % layout.columns;
  const double left_cm_here = layout.left_cm_of(index), below_cm = layout.below_cm(index / layout.columns);
  const double above_cm = below_cm + layout.panel_cm;
  return fmt::format(
      "set object circle at shoulder_x, shoulder_y size reach front fs empty border lc rgb ink lw 0.6 dt 2\n"
      "set lmargin at screen margin({})\nset rmargin at screen margin({})\nset bmargin at screen up({})\n"
      "set tmargin at screen up({})\nset format y '{}'\n"
      "set label 1001 {} at graph 0.5, screen up({}) center noenhanced tc rgb ink\n"
      "set label 1002 '{} of {}' at graph 0.5, screen up({}) center tc rgb ink\n",
      text_of(left_cm_here), text_of(left_cm_here + layout.panel_cm), text_of(below_cm), text_of(above_cm),
      column == 0 ? "%g" : "", gnuplot_text(panel.label), text_of(above_cm + 0.56), panel.solved, counted,
      text_of(above_cm + 0.2));
}

// Returns "x" for a direction along an axis of the base, and a word for any other.
std::string axis_name(const std::vector<double>& direction, const char* otherwise) {
  constexpr double nearly = 1 - 1e-9;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (direction[axis] > nearly) return std::string(1, "xyz"[axis]);
  return otherwise;
}

// The part of the plane that each panel shows [m].
struct MapRange {
  double x, y;  // the shoulder, in the middle
  double side;  // from the middle to each edge
};

MapRange range_of(const TargetGrid& grid) {
  const auto along = [&](const std::vector<double>& direction) {
    return std::inner_product(direction.begin(), direction.end(), grid.shoulder.begin(), 0.0);
  };
  return {along(grid.across), along(grid.up), std::max(1.04 * grid.reach, grid.reach + 0.7 * grid.step)};
}

// Returns the settings of the axes, which are the same for all panels.
std::string axes_of(const TargetGrid& grid, const MapLayout& layout) {
  const auto [x, y, side] = range_of(grid);
  const double ticks = std::clamp(layout.panel_cm / 0.9, 2.0, 5.0);
  const double wide_step = round_step_of(2 * side, ticks);
  const double step = wide_step < 0.9 * side ? wide_step : round_step_of(2 * side, 2 * ticks);  // at least two ticks
  return fmt::format(
      "shoulder_x = {0}\nshoulder_y = {1}\nreach = {2}\nset xrange [{3}:{4}]\nset yrange [{5}:{6}]\nset size ratio -1\n"
      "set xtics {7}\nset ytics {7}\nset tics scale 0.4\nset format x '%g'\nset border 15 lw 0.4\nunset grid\n"
      "unset key\nset samples 2\n{8}{9}",
      text_of(x), text_of(y), text_of(grid.reach), text_of(x - side), text_of(x + side), text_of(y - side),
      text_of(y + side), text_of(step), title_of('x', axis_name(grid.across, "across") + " [m]"),
      title_of('y', axis_name(grid.up, "up") + " [m]"));
}

// Returns the titles of the axes, which are drawn once for all panels.
std::string titles_of(const MapLayout& layout) {
  const double width_cm = left_cm + static_cast<double>(layout.columns) * (layout.panel_cm + between_cm) - between_cm;
  const double below_cm = layout.legend_cm + title_cm + ticks_cm;
  return fmt::format(
      "set label x_title at screen margin({}), screen up({}) center tc rgb ink\n"
      "set label y_title at screen margin(0.3), screen up({}) center rotate tc rgb ink\n",
      text_of((left_cm + width_cm) / 2), text_of(layout.legend_cm + 0.15),
      text_of((below_cm + layout.height_cm() - head_cm) / 2));
}

// Returns the first panel that has colours; the number of panels if none has.
std::size_t first_with_values(const std::vector<MapPanel>& panels) {
  const auto has_value = [](const MapCell& cell) { return cell.value > 0; };
  const auto has_values = [&](const MapPanel& panel) { return std::ranges::any_of(panel.cells, has_value); };
  return static_cast<std::size_t>(std::ranges::find_if(panels, has_values) - panels.begin());
}

// Returns the numbers by which the page says what is below the pointer: the part of the picture that each panel takes,
// from its lower left corner, as shares of the picture's width; the part of the plane [m]; the places with their
// targets; and the value of each place in each panel, -1 where a solved target has no value, 0 where none is solved,
// and null where the solver has not solved it yet. `scale` is the share of the picture's width that 1 cm of the layout
// takes.
std::string pointer_of(const JudgedStudy& judged, const std::vector<MapPanel>& panels, const MapKinds& kinds,
                       const MapLayout& layout, double scale) {
  const TargetGrid& grid = judged.study.definition.grid;
  const MapRange range = range_of(grid);
  base::Json pointer = {{"axes", {axis_name(grid.across, "across"), axis_name(grid.up, "up")}},
                        {"low", {range.x - range.side, range.y - range.side}},
                        {"side", 2 * range.side},
                        {"step", grid.step},
                        {"directions", grid.directions},
                        {"reach", grid.reach},
                        {"blank", kinds.blank_words()},
                        {"places", base::Json::array()},
                        {"panels", base::Json::array()}};
  const auto rounded = [](double length) { return std::round(length * 1e5) / 1e5; };
  for (const MapPlace& place : places_of(judged))
    pointer["places"].push_back({rounded(place.across), rounded(place.up), judged.targets.targets[place.begin].point});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    base::Json values = base::Json::array();
    for (const MapCell& cell : panels[i].cells) {
      const bool is_uncounted = cell.state == MapCell::State::solved && std::isnan(cell.value);
      if (cell.state == MapCell::State::missing)
        values.push_back(nullptr);
      else
        values.push_back(is_uncounted ? -1 : std::fmax(0, cell.value));
    }
    pointer["panels"].push_back({{"label", panels[i].label},
                                 {"left", scale * layout.left_cm_of(i)},
                                 {"below", scale * layout.below_cm(i / layout.columns)},
                                 {"size", scale * layout.panel_cm},
                                 {"values", std::move(values)}});
  }
  return base::text_of(pointer);
}

std::string caption_of(const JudgedStudy& judged, const MapKinds& kinds) {
  const results::StudyDefinition& definition = judged.study.definition;
  const bool has_directions = definition.grid.directions > 1;
  std::string text = fmt::format("Where each solver solves the targets of a grid: {}.", definition.grid_text());
  if (kinds.has_values())
    text += has_directions ? " Colours: how many directions of the tool." : " Colours: evaluations.";
  if (kinds.are_behind) text += fmt::format(" Crosses: another solver solves {}.", has_directions ? "more" : "it");
  if (kinds.is_partial) text += " Solves are missing.";
  if (kinds.are_not_asked) text += " White places may not be solved yet.";
  if (kinds.are_missing) text += " Dots: not solved yet by this solver.";
  if (kinds.are_unsolved)
    text += fmt::format(" Grey: no solver solves it{}, which is no proof that the arm cannot reach it.",
                        kinds.is_partial ? " so far" : "");
  text += " Dashed: no tool is beyond; plus: the shoulder.";
  if (definition.grid.left_out > 0)
    text += fmt::format(" Without {} targets that are certainly out of reach.", definition.grid.left_out);
  return text;
}

}  // namespace

std::vector<MapPanel> map_panels(const JudgedStudy& judged, const Look& look) {
  std::vector<MapPanel> panels;
  if (!judged.study.definition.is_grid() || judged.study.grid_places.empty()) return panels;
  const SolvedTargets& targets = judged.targets;
  const std::vector<MapPlace> places = places_of(judged);
  std::vector<std::size_t> most(places.size(), 0);
  for (std::size_t solver = 0; solver < targets.solvers.size(); ++solver)
    for (std::size_t i = 0; i < places.size(); ++i) most[i] = std::max(most[i], solved_at(targets, places[i], solver));
  for (const std::string& name : drawn_solvers(judged.study, look)) {
    const auto solver = static_cast<std::size_t>(std::ranges::find(targets.solvers, name) - targets.solvers.begin());
    if (solver == targets.solvers.size()) continue;
    panels.push_back(panel_of(judged, places, most, solver));
    panels.back().label = look.names.at(name);
  }
  return panels;
}

std::optional<Figure> map_of(const JudgedStudy& judged, const Look& look) {
  std::vector<MapPanel> panels = map_panels(judged, look);
  if (panels.empty()) return std::nullopt;
  const TargetGrid& grid = judged.study.definition.grid;
  const bool has_directions = grid.directions > 1;
  const auto solvable =
      judged.targets.targets.size() -
      static_cast<std::size_t>(std::ranges::count(judged.targets.targets, std::size_t{0}, &SolvedTarget::solvers));
  Figure figure{.name = "map"};
  std::string left_out;
  if (panels.size() > most_panels) {
    left_out = fmt::format(" Only {} of {} solvers are drawn.", most_panels, panels.size());
    panels.resize(most_panels);
  }
  const MapKinds kinds = kinds_of(judged, panels);
  figure.caption = caption_of(judged, kinds) + left_out;
  figure.width_cm = map_width_cm(panels.size(), look.style);
  const double legend_cm = legend_cm_of(kinds);
  const MapLayout layout = layout_of(panels.size(), figure.width_cm, legend_cm, look.style);
  figure.height_cm = layout.height_cm();
  figure.sides_cm = 0;  // the panels take all of the width
  figure.is_dense = panels.size() * panels.front().cells.size() > most_svg_cells;
  if (look.style.height_cm == 0)  // otherwise the size of text changes with the height of the picture
    figure.pointer = pointer_of(judged, panels, kinds, layout, look.style.text_pt / 8 / figure.width_cm);
  figure.data = data_of(panels);
  figure.settings =
      "uncounted = '#56B4E9'\nunsolved = dark ? faint : '#E8E8E8'\n" + colours_of(kinds, grid) + axes_of(grid, layout);
  figure.plot = "set multiplot\n" + titles_of(layout) + legend_of(kinds, has_directions);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const bool has_bar = i == first_with_values(panels);
    figure.plot += has_bar ? bar_of(layout, legend_cm, has_directions) : "unset colorbox\n";
    figure.plot += panel_commands(panels[i], i, layout, solvable > 0 ? solvable : judged.targets.targets.size()) +
                   panel_plot(i, grid.step / 2) + "unset label\nunset object\n";
  }
  figure.plot += "unset multiplot";
  return figure;
}

}  // namespace ikbench::figures
