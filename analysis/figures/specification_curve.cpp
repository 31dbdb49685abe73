#include "analysis/figures/specification_curve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace inference;

namespace {

constexpr double curve_rows = 13;  // height of the curve, in rows of the choices below it
constexpr double row_height_cm = 0.37;
constexpr std::size_t longest_choice = 60;
constexpr double farthest = 2;          // an interval reaches so many decades beyond all estimates; the rest is cut
constexpr double label_width = 0.0075;  // of a letter, relative to the figure's; gnuplot guesses twice that for SVG

// The axis that places log10 ratios above the rows.
struct CurveAxis {
  double low = -0.5, high = 0.5;
  double at(double value) const { return 1 + (value - low) / (high - low) * (curve_rows - 1); }
};

CurveAxis curve_axis(const SpecificationCurve& curve) {
  CurveAxis estimates, axis;
  for (const SpecificationCurve::Universe& each : curve.universes) {
    if (!std::isfinite(each.estimate)) continue;
    estimates.low = std::min(estimates.low, each.estimate);
    estimates.high = std::max(estimates.high, each.estimate);
  }
  axis = estimates;
  for (const SpecificationCurve::Universe& each : curve.universes) {
    if (each.low < axis.low) axis.low = std::max(each.low, estimates.low - farthest);
    if (each.high > axis.high) axis.high = std::min(each.high, estimates.high + farthest);
  }
  return axis;
}

// Whole decades, as ratios: all as powers if one of them is far from 1.
std::vector<std::string> curve_ticks(const CurveAxis& axis) {
  std::vector<std::string> ticks;
  const int step = axis.high - axis.low > 8 ? 2 : 1;
  for (int decade = -20; decade <= 20; ++decade) {
    if (decade % step != 0 || decade < axis.low || decade > axis.high) continue;
    const bool is_near = axis.low > -3 && axis.high < 3;
    const std::string label = is_near ? text_of(std::pow(10, decade)) : fmt::format("10^{{{}}}", decade);
    ticks.push_back(fmt::format("'{}' {}", label, text_of(axis.at(decade))));
  }
  return ticks;
}

// Escapes a text for labels of enhanced text.
std::string literal_label(std::string_view text) {
  constexpr std::string_view meaningful = "_^{}@&~\\";
  std::string escaped;
  for (const char c : text) {
    if (meaningful.find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return tick_label(escaped);
}

}  // namespace

Figure specification_curve(const SpecificationCurve& curve) {
  const CurveAxis axis = curve_axis(curve);
  std::vector<std::string> ticks = curve_ticks(axis);
  std::vector<double> places;
  double place = 0;
  std::size_t longest = 8;  // characters
  std::string lines;
  for (const std::vector<std::string>& group : curve.groups) {
    place -= 0.45;
    lines += fmt::format("set arrow from graph 0, first {0} to graph 1, first {0} nohead back ls 1000\n",
                         text_of(place - 0.27));
    for (const std::string& row : group) {
      places.push_back(place -= 1);
      const std::string label = row_label(row, longest_choice);
      longest = std::max(longest, character_count(label));
      ticks.push_back(fmt::format("{} {}", literal_label(label), text_of(place)));
    }
  }
  Figure figure{.name = curve.name,
                .caption = curve.caption,
                .width_cm = two_columns_cm,
                .height_cm = 1.6 + row_height_cm * (curve_rows - place)};
  figure.settings = fmt::format(
      "set key at screen 0.03, 0.9 left top vertical maxcols 1\nset lmargin at screen margin({})\nset rmargin at screen 0.97\n"
      "set xrange [0:100]\nset yrange [{}:{}]\n"
      "set xlabel 'interpretations, sorted [%]'\nset ytics enhanced ({})\nset grid noytics noxtics\n"
      "set label {} at graph 0.01, first {} left\n{}",
      text_of(two_columns_cm * (0.03 + label_width * static_cast<double>(longest))), text_of(place - 0.6),
      text_of(curve_rows + 0.6), fmt::join(ticks, ", "), gnuplot_string(curve.quantity), text_of(curve_rows - 0.2),
      lines);
  figure.settings += fmt::format("set arrow from graph 0, first {0} to graph 1, first {0} nohead back ls 1001 lw 0.8\n",
                                 text_of(axis.at(0)));
  figure.data =
      "# share of interpretations before it [%], log10 of the ratio, its interval, their places in the picture; side of "
      "the interval, -1: below 1, 1: above, 0: neither\n";
  std::string choices = "\n\n# share of interpretations before it [%], row of a choice, side of its interval\n";
  bool is_cut = false;
  for (std::size_t i = 0; i < curve.universes.size(); ++i) {
    const SpecificationCurve::Universe& each = curve.universes[i];
    const double x = 100 * (static_cast<double>(i) + 0.5) / static_cast<double>(curve.universes.size());
    const double side = each.high < 0 ? -1 : each.low > 0 ? 1 : 0;
    const auto shown = [&](double value) { return axis.at(std::clamp(value, axis.low, axis.high)); };
    is_cut = is_cut || each.low < axis.low || each.high > axis.high;
    figure.data += data_line(
        {x, each.estimate, each.low, each.high, shown(each.estimate), shown(each.low), shown(each.high), side});
    for (const std::size_t row : each.rows) choices += data_line({x, places.at(row), side});
  }
  figure.data += choices;
  if (is_cut) figure.caption += " Longer intervals are cut at the edge of the picture.";
  std::vector<std::string> clauses;
  const auto add = [&](int side, std::string_view colour, std::string_view title) {
    clauses.push_back(fmt::format(
        "data index 0 using 1:($8 == {} ? $6 : NaN):(0):($7 - $6) with vectors nohead lw 0.5 lc rgb {}", side, colour));
    clauses.push_back(
        fmt::format("data index 0 using 1:($8 == {} ? $5 : NaN) with points pt 7 ps 0.3 lc rgb {}", side, colour));
    clauses.push_back(
        fmt::format("data index 1 using 1:($3 == {} ? $2 : NaN) with points pt 7 ps 0.25 lc rgb {}", side, colour));
    clauses.push_back(
        fmt::format("keyentry with points pt 7 ps 0.6 lc rgb {} title {}", colour, gnuplot_string(title)));
  };
  add(-1, "word(colours, 1)", curve.below);
  add(1, "word(colours, 2)", curve.above);
  add(0, "'#999999'", "undecided");
  figure.plot = plot_command(clauses);
  return figure;
}

}  // namespace ikbench::figures
