#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "analysis/figures/parts.hpp"
#include "analysis/figures/plots.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;

// The curve stands above the rows of the choices, on one axis that counts rows; 1 is its lowest.
Figure specifications(const About& about, const Specifications& rows) {
  constexpr double curve_rows = 13, row_cm = 0.42,
                   farthest = 2;    // decades beyond all estimates, where intervals are cut
  double least = -0.5, most = 0.5;  // log10 of ratios
  const auto log10_of = [](double ratio) { return std::log10(std::clamp(ratio, 1e-300, 1e300)); };
  for (const Specification& each : rows.all) {
    least = std::min(least, log10_of(each.estimate));
    most = std::max(most, log10_of(each.estimate));
  }
  double low = least, high = most;
  for (const Specification& each : rows.all) {
    low = std::min(low, std::max(log10_of(each.low), least - farthest));
    high = std::max(high, std::min(log10_of(each.high), most + farthest));
  }
  const auto row_of = [&](double ratio) {
    return 1 + (std::clamp(log10_of(ratio), low, high) - low) / (high - low) * (curve_rows - 1);
  };
  Figure figure{.name = about.name, .caption = about.caption, .width_cm = two_columns_cm};
  std::vector<std::string> ticks;
  for (double decade = std::ceil(low); decade <= high; decade += high - low > 8 ? 2 : 1) {
    ticks.push_back(fmt::format("'' {}", text_of(row_of(std::pow(10, decade)))));
    figure.settings += fmt::format("set label '{}' at graph 0, first {} right offset -1, 0\n",
                                   power(std::pow(10, decade)), text_of(row_of(std::pow(10, decade))));
  }
  double place = 0, widest_cm = 1;
  std::vector<std::vector<double>> places;  // of the choices
  for (const std::vector<std::string>& group : rows.groups) {
    place -= 0.45;
    figure.settings += fmt::format("set arrow from graph 0, first {0} to graph 1, first {0} nohead back ls 1000\n",
                                   text_of(place - 0.27));
    places.emplace_back();
    for (const std::string& choice : group) {
      places.back().push_back(place -= 1);
      const std::string label = label_of(choice);
      widest_cm = std::max(widest_cm, width_cm_of(label));
      ticks.push_back(fmt::format("{} {}", gnuplot_text(label), text_of(place)));
    }
  }
  figure.height_cm = 1.6 + row_cm * (curve_rows - place);
  figure.sides_cm = widest_cm + 0.8;
  add_legend_of(figure, {label_of(rows.below), label_of(rows.above), "not decided"});
  add_margins(figure);
  figure.settings += fmt::format(
      "set lmargin at screen margin({})\nset rmargin at screen 0.98\nset xrange [0:100]\n"
      "set yrange [{}:{}]\nset xlabel 'readings, sorted [%]'\nset ytics noenhanced ({})\nset grid noytics noxtics\n"
      "set label {} at graph 0.99, first 1.6 right noenhanced\nset arrow from graph 0, first {} to graph 1, first {} nohead back ls 1001 lw 0.8\n",
      text_of(widest_cm + 0.4), text_of(place - 0.6), text_of(curve_rows + 0.6), fmt::join(ticks, ", "),
      gnuplot_text(about.quantity), text_of(row_of(1)), text_of(row_of(1)));
  figure.data =
      "# share of readings before it [%]; ratio, low, high; their rows; side of the verdict: -1 below 1, 1 above\n";
  std::string choices = "\n\n# share of readings before it [%], row of a choice, side of its verdict\n";
  for (std::size_t i = 0; i < rows.all.size(); ++i) {
    const Specification& each = rows.all[i];
    const double x = 100 * (static_cast<double>(i) + 0.5) / static_cast<double>(rows.all.size());
    const double side = each.side;
    figure.data += data_row(
        {x, each.estimate, each.low, each.high, row_of(each.estimate), row_of(each.low), row_of(each.high), side});
    for (std::size_t group = 0; group < each.choices.size(); ++group)
      choices += data_row({x, places.at(group).at(each.choices[group]), side});
  }
  figure.data += choices;
  struct Side {
    int side;
    std::string_view colour;
    std::string meaning;
  };
  std::vector<std::string> clauses;
  for (const auto& [side, colour, meaning] : {Side{-1, "word(colours, 1)", rows.below},
                                              {1, "word(colours, 2)", rows.above},
                                              {0, "'#999999'", "not decided"}}) {
    clauses.push_back(fmt::format(
        "data index 0 using 1:($8 == {} ? $6 : NaN):(0):($7 - $6) with vectors nohead lw 0.5 lc rgb {}", side, colour));
    clauses.push_back(
        fmt::format("data index 0 using 1:($8 == {} ? $5 : NaN) with points pt 7 ps 0.3 lc rgb {}", side, colour));
    clauses.push_back(
        fmt::format("data index 1 using 1:($3 == {} ? $2 : NaN) with points pt 7 ps 0.25 lc rgb {}", side, colour));
    clauses.push_back(
        fmt::format("keyentry with points pt 7 ps 0.6 lc rgb {} title {}", colour, gnuplot_text(meaning)));
  }
  figure.plot = plotted(clauses);
  return figure;
}

}  // namespace ikbench::figures
