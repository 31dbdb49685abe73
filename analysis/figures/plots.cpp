#include "analysis/figures/plots.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "analysis/figures/parts.hpp"
#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::figures {

using namespace base;

namespace {

const std::string grey = colour_of(0);
constexpr std::size_t most_rows = 60;      // of one figure, so that it fits a page
constexpr std::size_t most_values = 200;   // drawn per group
constexpr std::size_t most_columns = 500;  // of targets
constexpr std::size_t most_bands = 3;      // more would cover each other

// Returns the first rows. If others are left out, adds the number of drawn rows to the picture, and the names of the
// others to the caption.
template <class Row>
std::span<const Row> drawn_of(const std::vector<Row>& all, std::size_t most, Figure& figure) {
  std::vector<std::string> others;
  for (std::size_t i = most; i < all.size(); ++i) others.push_back(all[i].label);
  if (!others.empty()) {
    figure.caption += fmt::format(" Left out: {}; only {} are drawn.", names_of(others), most);
    figure.settings += fmt::format("set label '{} of {}' at screen margin(0.15), screen 1 - up(0.15) left tc rgb ink\n",
                                   most, all.size());
  }
  return std::span(all).first(all.size() - others.size());
}

// Adds words at the right of rows.
void add_remarks(Figure& figure, const std::vector<std::string>& remarks) {
  double widest_cm = 0;
  for (std::size_t i = 0; i < remarks.size(); ++i) {
    if (remarks[i].empty()) continue;
    widest_cm = std::max(widest_cm, width_cm_of(remarks[i]));
    figure.settings += fmt::format("set label {} at graph 1, first {} left offset 0.6, 0 noenhanced tc rgb ink\n",
                                   gnuplot_text(remarks[i]), i + 1);
  }
  if (widest_cm == 0) return;
  figure.sides_cm += widest_cm;
  figure.settings += fmt::format("set rmargin at screen 1 - margin({})\n", text_of(widest_cm + 0.45));
}

// Returns the largest sets of rows, as bits, in which no two rows are apart. The method is insertion and absorption
// (Piepho, J. Computational and Graphical Statistics 13 (2004) 456).
std::vector<std::uint32_t> sets_of_alike(std::span<const RankRow> rows) {
  std::vector<std::uint32_t> sets{static_cast<std::uint32_t>((std::uint64_t{1} << rows.size()) - 1)};
  const auto is_within = [](const auto& others, std::uint32_t set) {
    return std::ranges::any_of(others, [=](std::uint32_t other) { return (other & set) == set; });
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      if (std::ranges::count(rows[i].apart, rows[j].label) == 0) continue;
      const std::uint32_t one = 1u << i, other = 1u << j;
      std::vector<std::uint32_t> split;
      for (const std::uint32_t set : sets) {
        const bool has_both = (set & one) != 0 && (set & other) != 0;
        split.push_back(has_both ? set & ~one : set);
        if (has_both) split.push_back(set & ~other);
      }
      std::ranges::stable_sort(split, std::ranges::greater(), [](std::uint32_t set) { return std::popcount(set); });
      sets.clear();
      std::ranges::copy_if(split, std::back_inserter(sets), [&](std::uint32_t set) { return !is_within(sets, set); });
    }
  }
  std::erase_if(sets, [](std::uint32_t set) { return std::popcount(set) < 2; });
  std::ranges::sort(sets, {}, [](std::uint32_t set) { return std::pair(std::countr_zero(set), std::bit_width(set)); });
  return sets;
}

// The commands of gnuplot for a row of panels per solver, with a panel per joint. Both have their names and styles in
// arrays. The arguments are: rows, columns, the gap between rows [cm], the height of a column's name above the first
// row, the point size.
constexpr const char* joint_panels =
    "set multiplot layout {0}, {1} rowsfirst margins margin(1.35), 1 - margin({4}), up(0.95), 1 - up(0.65 + {2}) "
    "spacing margin(0.15), up({2})\n"
    "do for [r=1:{0}] {{\n  do for [c=1:{1}] {{\n"
    "    unset label\n    unset title\n    set format ''\n"
    "    if (c == 1) {{ set format y '%g'; set label solver[r] at graph 0, graph 1 left offset 0, 0.6 noenhanced tc rgb ink }}\n"
    "    if (r == 1) {{ set label name[c] at graph 0.5, graph 1 center offset 0, {3} noenhanced tc rgb ink }}\n"
    "    if (r == 1 && c == 1) {{ set label y_title at screen margin(0.3), screen 0.5 center rotate tc rgb ink; "
    "set label x_title at screen 0.5, up(0.22) center tc rgb ink }}\n"
    "    if (r == {0} && c % 2 == 1) {{ set format x '%g' }}\n"
    "    plot NaN, lower[c] with lines lw 0.6 dt 2 lc rgb '#777777', \\\n"
    "      upper[c] with lines lw 0.6 dt 2 lc rgb '#777777', \\\n"
    "      data index r-1 using 1:(column(c+1)) with lines lw 0.9 lc rgb colour_of(style[r]), \\\n"
    "      data index r-1 using 1:(column(c+1) < lower[c] || column(c+1) > upper[c] ? column(c+1) : NaN) "
    "with points pt 6 ps 0.6 lw 0.8 lc rgb ink\n"
    "  }}\n}}\nunset multiplot";

// Returns gnuplot's word for the heads of an interval's line. An end without a place is beyond the axis and has a head.
const char* arrow_heads(bool has_low, bool has_high) {
  if (has_low) return has_high ? "nohead" : "head";
  return has_high ? "backhead" : "heads";
}

// Returns the step of the ticks of angles [deg].
double angle_step(double span) {
  if (span >= 270) return 180;
  if (span >= 135) return 90;
  if (span >= 60) return 30;
  return round_step_of(std::max(span, 1.0), 3);
}

// Sets the axes of a plot in space: a cube around the corners, seen from the front, above and the left. The key of a
// splot begins at the top.
void add_cube(Figure& figure, const Corner& low, const Corner& high) {
  const double side = std::max(0.1, 1.1 * (high - low).maxCoeff());
  figure.settings +=
      "set view equal xyz\nset view 65, 30, 1.3\n"
      "room = (1 - 2 * margin(1.35)) / 0.72\nroom = room < 1 ? room : 1\n"  // leaves room for the title of z
      "set origin (1 - room) / 2, up(legend_rows_cm + 0.2)\nset size room, 1 - up(legend_rows_cm + 0.2)\n"
      "set key at screen 0.5, screen up(legend_rows_cm + 0.1) top center\n"
      "set border 895 lw 0.5 lc rgb '#AAAAAA'\nset grid x y z vertical\n"
      "set xtics offset 0, 0\nset ztics offset 1.2, 0\n";
  const Corner middle = (low + high) / 2;
  const double step = round_step_of(side, 5);
  for (const int axis : {0, 1, 2})
    figure.settings += fmt::format("set {0}range [{1}:{2}]\nset {0}tics {3} textcolor rgb ink\n", "xyz"[axis],
                                   text_of(middle[axis] - side / 2), text_of(middle[axis] + side / 2), text_of(step));
  // Titles stand beside the middles of their axes. gnuplot would place titles by the area of the plot, which the cube
  // does not fill.
  const auto title = [&](char axis, std::array<double, 3> ends, std::string_view place) {
    std::string at;
    for (const int i : {0, 1, 2})
      at += (i > 0 ? ", " : "") + text_of(middle[i] + ends[static_cast<std::size_t>(i)] * side / 2);
    figure.settings += fmt::format("set label '{} [cm]' at {} {} tc rgb ink\n", axis, at, place);
  };
  title('x', {0, -1, -1}, "center offset -2.2, -2");
  title('y', {1, 0, -1}, "left offset 3.5, -1.3");
  title('z', {-1, -1, 0}, "center rotate offset -5.8, 0");
  figure.settings += fmt::format("set xyplane at {}\n", text_of(middle[2] - side / 2));
}

// Returns the lines of a data file for the values beside a row: value and height.
std::string scattered(const BoxRow& row, double y) {
  std::vector<double> sorted = row.values;
  std::ranges::sort(sorted);
  const std::size_t n = std::min(sorted.size(), most_values);
  std::string lines = fmt::format("\n\n# values of {}: value, height\n", one_line(row.label));
  if (n == 0) lines += "NaN NaN\n";
  for (std::size_t k = 0; k < n; ++k) {
    constexpr double golden_ratio = 0.6180339887498949;  // multiples of it fill an interval evenly
    const double jitter = std::fmod(golden_ratio * static_cast<double>(k + 1), 1.0);
    lines += data_row({sorted[n == sorted.size() ? k : k * (sorted.size() - 1) / (n - 1)], y + 0.02 + 0.2 * jitter});
  }
  return lines;
}

}  // namespace

std::optional<Figure> boxes(const About& about, const std::vector<BoxRow>& all_rows) {
  Figure figure{.name = about.name, .caption = about.caption};
  const auto rows = drawn_of(all_rows, most_rows, figure);
  std::vector<std::string> labels, clauses, remarks;
  std::vector<double> all;
  figure.data =
      "# row; smallest, lower quartile, median, upper quartile, largest; as printed: smallest, median, largest\n";
  std::string values;
  bool is_thinned = false, has_printed = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BoxRow& row = rows[i];
    const auto y = static_cast<double>(i + 1);
    labels.push_back(row.label);
    remarks.push_back(row.remark);
    all.insert(all.end(), row.values.begin(), row.values.end());
    all.insert(all.end(), row.box.begin(), row.box.end());
    all.insert(all.end(), row.printed.begin(), row.printed.end());
    has_printed = has_printed || !std::isnan(row.printed[1]);
    figure.data += fmt::format("# {}\n{}", one_line(row.label),
                               data_row({y, row.box[0], row.box[1], row.box[2], row.box[3], row.box[4], row.printed[0],
                                         row.printed[1], row.printed[2]}));
    is_thinned = is_thinned || row.values.size() > most_values;
    values += scattered(row, y);
    const std::string box = fmt::format("data index 0 every ::{0}::{0} using", i), colour = colour_of(row.style);
    clauses.push_back(
        fmt::format("data index {} using (place_x($1)):2 with points pt 6 ps 0.3 lw 0.7 {}", i + 1, colour));
    clauses.push_back(fmt::format(
        "{} (place_x($2)):($1-0.2):(place_x($6)-place_x($2)):(0) with vectors nohead lw 0.9 {}", box, colour));
    clauses.push_back(
        fmt::format("{} (place_x($4)):($1-0.2):(place_x($3)):(place_x($5)):($1-0.33):($1-0.07) with boxxyerror "
                    "fs @filled 0.15 border lw 0.9 {}",
                    box, colour));
  }
  if (std::ranges::none_of(all, [](double value) { return std::isfinite(value); })) return std::nullopt;
  figure.data += values;
  add_labelled_rows(figure, labels, has_printed ? 0.8 : 0.65);
  figure.settings += value_axis('x', all, about, Begins::around).settings;
  add_remarks(figure, remarks);
  const auto has_no_answer = [](const BoxRow& row) { return std::isinf(row.box.back()); };
  if (std::ranges::any_of(rows, has_no_answer)) figure.caption += " At the right edge: no answer.";
  if (is_thinned) figure.caption += fmt::format(" Only {0} values per solver, at even ranks, are drawn.", most_values);
  clauses.emplace_back("data index 0 using (place_x($4)):($1-0.33):(0):(0.26) with vectors nohead lw 1.6 lc rgb ink");
  if (has_printed) {
    clauses.push_back(fmt::format(
        "data index 0 using (place_x($7)):($1+0.34):(place_x($9)-place_x($7)):(0) with vectors nohead lw 1 {}", grey));
    clauses.push_back(
        fmt::format("data index 0 using (place_x($8)):($1+0.27):(0):(0.14) with vectors nohead lw 1.6 {}", grey));
    clauses.emplace_back("keyentry with points pt 6 ps 0.3 lw 0.7 lc rgb ink title 'ours'");
    clauses.push_back(fmt::format("keyentry with lines lw 1 {} title 'paper: smallest, median, largest'", grey));
    add_legend(figure, 2);
  }
  figure.plot = plotted(clauses);
  return figure;
}

std::optional<Figure> curves(const About& about, const CurveAxis& axis, std::vector<Line> all) {
  std::erase_if(all, [](const Line& line) {
    return std::ranges::none_of(line.rows, [](const CurveRow& row) { return std::isfinite(row.y); });
  });
  if (all.empty()) return std::nullopt;
  Figure figure{.name = about.name, .caption = about.caption};
  const std::size_t drawn = drawn_of(all, most_lines, figure).size();
  std::vector<double> xs, ys;
  std::vector<std::string> back, front;
  std::vector<Named> ends;
  figure.data = fmt::format("# {}; {}; low, high\n", one_line(axis.title), about.axis());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Line& line = all[i];
    figure.data += fmt::format("{}# {}\n", i == 0 ? "" : "\n\n", one_line(line.label));
    for (const CurveRow& row : line.rows) figure.data += data_row({row.x, row.y, row.low, row.high});
    if (i >= drawn) continue;
    const bool has_band = (axis.has_bars || all.size() <= most_bands) &&
                          std::ranges::any_of(
                              line.rows, [](double high) { return !std::isnan(high); }, &CurveRow::high);
    const std::string style =
        line.style > 0 ? fmt::format("ls {}", line.style) : fmt::format("lw 0.7 dt 2 {} pt 6 ps 0.9", grey);
    Named& end = ends.emplace_back(Named{line.label, line.style});
    for (const CurveRow& row : line.rows) {
      xs.push_back(row.x);
      ys.push_back(row.y);
      if (has_band) ys.insert(ys.end(), {row.low, row.high});
      if (!std::isnan(row.y)) end.y = row.y;
    }
    const std::string rows = fmt::format("data index {} using 1:", i);
    if (has_band && axis.has_bars)
      // The marker of the line covers the dot; a marker of size 0 would become a scale of 0, which SVG viewers refuse.
      back.push_back(
          fmt::format("{}(place_y($2)):(place_y($3)):(place_y($4)) with yerrorbars {} lw 0.7 pt 0", rows, style));
    else if (has_band)
      back.push_back(fmt::format(
          "{}(place_y($3)):(place_y($4)) with filledcurves {} fs transparent solid 0.13 noborder", rows, style));
    front.push_back(
        fmt::format("{}(place_y($2)) with linespoints {} pointinterval {}", rows, style, 1 + line.rows.size() / 25));
  }
  if (!back.empty()) figure.caption += axis.has_bars ? " Bars: 95 % intervals." : " Bands: quartiles.";
  const Axis y = value_axis('y', ys, about, Begins::at_zero);
  const Axis x = axis.may_be_logarithmic ? value_axis('x', xs, {.quantity = axis.title}, Begins::at_first)
                                         : linear_axis('x', xs, axis.title, Begins::at_first);
  figure.settings += y.settings + x.settings;
  for (Named& end : ends) end.y = y.share_of(end.y);
  add_names(figure, ends);
  std::ranges::move(front, std::back_inserter(back));
  figure.plot = plotted(back);
  return figure;
}

std::optional<Figure> shares(const About& about, const std::string& y_axis, const std::vector<Successes>& all,
                             double dashed) {
  Figure figure{.name = about.name, .caption = about.caption};
  const std::size_t drawn = drawn_of(all, most_lines, figure).size();
  std::vector<std::string> clauses;
  std::vector<Named> ends;
  std::vector<double> costs;
  for (const Successes& each : std::span(all).first(drawn))
    costs.insert(costs.end(), each.costs.begin(), each.costs.end());
  const bool is_dashed = !std::isnan(dashed);
  constexpr double farthest = 1000;  // factor from the dashed line, on both sides
  if (is_dashed) std::erase_if(costs, [&](double cost) { return cost > dashed * farthest; });
  if (costs.empty()) return std::nullopt;
  if (is_dashed) costs.push_back(dashed);
  auto [smallest, largest] = std::ranges::minmax(costs);
  if (is_dashed) smallest = std::max(smallest, dashed / farthest);
  const Axis axis = logarithmic_axis('x', smallest, largest, about.axis());
  figure.data = fmt::format("# {}, share of all attempts [%]\n", about.axis());
  const Axis y = linear_axis('y', std::vector<double>{0, 100}, y_axis + " [%]", Begins::around);
  for (std::size_t i = 0; i < all.size(); ++i) {
    costs = all[i].costs;
    std::ranges::sort(costs);
    const auto share_of = [&](std::ptrdiff_t n) { return 100 * double(n) / static_cast<double>(all[i].attempts); };
    const auto first = std::ranges::lower_bound(costs, axis.low), last = std::ranges::upper_bound(costs, axis.high);
    figure.data += fmt::format("{}# {}\n{}", i == 0 ? "" : "\n\n", one_line(all[i].label),
                               data_row({0, share_of(first - costs.begin())}));
    std::size_t steps = 0;
    for (auto cost = first; cost < last; ++cost) {
      if (cost + 1 != last && cost[1] == cost[0]) continue;
      figure.data += data_row({*cost, share_of(cost + 1 - costs.begin())});
      ++steps;
    }
    const double share = share_of(last - costs.begin());
    figure.data += data_row({1e300, share});
    if (i >= drawn) continue;
    const std::string style = fmt::format("ls {} lw 1.3", all[i].style);
    ends.push_back({all[i].label, all[i].style, y.share_of(share)});
    constexpr std::string_view rows = "using (place_x($1)):2 with";
    clauses.push_back(fmt::format("data index {} {} steps {}", i, rows, style));
    const std::size_t every = 1 + steps / 6;  // steps between markers, which each line has at other steps
    if (drawn > 1)
      clauses.push_back(fmt::format("data index {} every {}::{} {} points ls {}", i, every, 1 + every * i / drawn, rows,
                                    all[i].style));
  }
  figure.settings += axis.settings + y.settings;
  if (is_dashed) {
    const bool is_near_edge = axis.share_of(dashed) > 0.7;  // beyond which names of lines stand
    figure.settings += fmt::format(
        "set arrow from {0}, graph 0 to {0}, graph 1 nohead back lw 0.8 dt 2 {1}\n"
        "set label 'tolerance' at {0}, graph 1 {2} offset 0, 0.3 tc rgb ink\n",
        text_of(dashed), grey, is_near_edge ? "right" : "left");
  }
  add_names(figure, ends);
  figure.plot = plotted(clauses);
  return figure;
}

std::optional<Figure> ranks(const About& about, const std::vector<RankRow>& all_rows, double ruler) {
  Figure figure{.name = about.name, .caption = about.caption};
  const auto rows = drawn_of(all_rows, 20, figure);
  std::vector<std::string> labels, clauses;
  std::vector<double> places;
  for (const RankRow& row : rows) {
    labels.push_back(row.label);
    places.push_back(row.place);
  }
  const std::vector<std::uint32_t> bars = sets_of_alike(rows);
  figure.data = fmt::format("# row, {}, and of each bar whether it joins it\n", about.axis());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<double> numbers{static_cast<double>(i + 1), rows[i].place};
    for (const std::uint32_t bar : bars) numbers.push_back(bar >> i & 1);
    figure.data += fmt::format("# {}\n{}", one_line(rows[i].label), data_row(numbers));
    clauses.push_back(
        fmt::format("data every ::{0}::{0} using (place_x($2)):1 with points ls {1} dt 1 ps 0.9", i, rows[i].style));
  }
  if (ruler > 0) {
    labels.push_back(fmt::format("CD {:.3g}", ruler));
    places.push_back(places[0] + ruler);
    figure.settings += fmt::format(
        "set arrow from first {0}, first {2} to first {1}, first {2} heads size screen 0.01,90 lw 1.2 lc rgb ink\n",
        text_of(places[0]), text_of(places.back()), labels.size());
  }
  add_labelled_rows(figure, labels, 0.42);
  figure.settings += value_axis('x', places, about, Begins::around).settings;
  const double pitch_cm = std::min(0.3, 3.0 / static_cast<double>(bars.size())),
               room_cm = pitch_cm * static_cast<double>(bars.size());
  figure.sides_cm += room_cm;
  figure.settings += fmt::format("set rmargin at screen 1 - margin({})\n", text_of(room_cm + 0.45));
  for (std::size_t b = 0; b < bars.size(); ++b) {
    const std::string x =
        fmt::format("screen 1 - margin({})", text_of(room_cm + 0.1 - pitch_cm * static_cast<double>(b)));
    figure.settings += fmt::format("set arrow from {0}, first {1} to {0}, first {2} nohead lw 2 {3}\n", x,
                                   std::countr_zero(bars[b]) + 1, std::bit_width(bars[b]), grey);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (bars[b] >> i & 1)
        figure.settings += fmt::format("set label '' at {}, first {} point pt 7 ps 0.5 {}\n", x, i + 1, grey);
    }
  }
  figure.plot = plotted(clauses);
  return figure;
}

std::optional<Figure> differences(const About& about, const std::vector<IntervalRow>& rows, bool are_ratios) {
  Figure figure{.name = about.name, .caption = about.caption};
  const double of_equals = are_ratios ? 1 : 0;
  std::vector<std::string> labels, clauses, verdicts;
  std::vector<double> all{of_equals};
  figure.data = fmt::format("# row, {}, low, high\n", are_ratios ? "ratio" : "difference");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const IntervalRow& row = rows[i];
    labels.push_back(row.label);
    verdicts.push_back(row.verdict);
    const auto has_place = [&](double value) { return std::abs(value) <= 1e300 && (!are_ratios || value > 0); };
    std::ranges::copy_if(std::array{row.estimate, row.low, row.high}, std::back_inserter(all), has_place);
    if (has_place(row.estimate) && !has_place(row.low) && are_ratios)
      all.push_back(row.estimate / 1.5);  // room for the head of the arrow
    const char* const heads = arrow_heads(has_place(row.low), has_place(row.high));
    figure.data += fmt::format("# {}\n{}", one_line(row.label),
                               data_row({static_cast<double>(i + 1), row.estimate, row.low, row.high}));
    const std::string line = fmt::format("data every ::{0}::{0} using", i), colour = colour_of(row.style);
    clauses.push_back(
        fmt::format("{} (place_x($3)):1:(place_x($4)-place_x($3)):(0) with vectors {} size screen 0.012,25 lw 1.6 {}",
                    line, heads, colour));
    clauses.push_back(
        fmt::format("{} (place_x($2)):1 with points pt {} ps 0.6 lw 1.2 {}", line, row.style > 0 ? 7 : 6, colour));
  }
  if (all.size() == 1) return std::nullopt;
  add_labelled_rows(figure, labels, 0.5);
  const auto [smallest, largest] = std::ranges::minmax(all);
  figure.settings += (are_ratios ? logarithmic_axis('x', smallest, largest, about.axis())
                                 : linear_axis('x', all, about.axis(), Begins::around))
                         .settings;
  figure.settings +=
      fmt::format("set arrow from {0}, graph 0 to {0}, graph 1 nohead back lw 0.8 dt 2 {1}\n", of_equals, grey);
  add_remarks(figure, verdicts);
  figure.plot = plotted(clauses);
  return figure;
}

Figure solved_rows(const About& about, const std::vector<SolvedRow>& all_rows, std::size_t solvable) {
  Figure figure{.name = about.name, .caption = about.caption};
  const auto rows = drawn_of(all_rows, most_rows, figure);
  const std::size_t targets = all_rows.front().is_solved.size();
  const std::size_t columns = std::min(targets, most_columns);
  const auto start_of = [=](std::size_t column) { return column * targets / columns; };
  if (columns < targets) figure.caption += fmt::format(" Only {} targets, at even ranks, are drawn.", columns);
  std::vector<std::string> labels, clauses, counts;
  figure.data = "# targets that are solved: after, to\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<bool>& is_solved = rows[i].is_solved;
    labels.push_back(rows[i].label);
    counts.push_back(fmt::to_string(std::ranges::count(is_solved, true)));
    figure.data += fmt::format("{}# {}\nNaN NaN\n", i == 0 ? "" : "\n\n", one_line(rows[i].label));
    // Neighbours are one box, because boxes side by side would show their edges.
    for (std::size_t begin = 0, end = 0; begin < columns; begin = end) {
      const bool is_filled = is_solved[start_of(begin)];
      for (end = begin + 1; end < columns && is_solved[start_of(end)] == is_filled;) ++end;
      if (is_filled)
        figure.data += data_row({static_cast<double>(start_of(begin)), static_cast<double>(start_of(end))});
    }
    clauses.push_back(fmt::format("data index {} using ($1):({}):1:2:({}):({}) with boxxyerror fs solid noborder {}", i,
                                  i + 1, text_of(static_cast<double>(i) + 0.65), text_of(static_cast<double>(i) + 1.35),
                                  colour_of(rows[i].style)));
  }
  add_labelled_rows(figure, labels, 0.42);
  figure.settings +=
      linear_axis('x', std::vector{0.0, static_cast<double>(targets)}, about.axis(), Begins::at_first).settings;
  if (solvable < targets)
    figure.settings +=
        fmt::format("set object rectangle from {}, graph 0 to {}, graph 1 behind fc rgb faint fs solid noborder\n",
                    solvable, targets);
  add_remarks(figure, counts);
  figure.plot = plotted(clauses);
  return figure;
}

Figure path(const About& about, const PathRows& rows) {
  Figure figure{.name = about.name, .caption = about.caption, .height_cm = 7};
  Corner low = Corner::Zero(), high = low;  // of all that is drawn, with the base
  const auto see = [&](const std::vector<Corner>& corners) {
    for (const Corner& corner : corners) {  // fmin and fmax pass over NaN
      low = low.binaryExpr(corner, [](double a, double b) { return std::fmin(a, b); });
      high = high.binaryExpr(corner, [](double a, double b) { return std::fmax(a, b); });
    }
  };
  figure.data = "# target x, y, z; reached x, y, z [cm]\n";
  for (std::size_t i = 0; i < rows.targets.size(); ++i) {
    const Corner &target = rows.targets[i], &reached = rows.reached[i];
    figure.data += data_row({target[0], target[1], target[2], reached[0], reached[1], reached[2]});
  }
  see(rows.targets);
  std::vector<std::string> clauses;
  const auto add = [&](const std::string& label, const std::string& what) {
    clauses.push_back(fmt::format("data index {} title {}", what, gnuplot_text(label)));
  };
  add("path", fmt::format("0 using 1:2:3 with lines lw 0.7 {}", grey));
  for (std::size_t i = 0; i < rows.arms.size(); ++i) {
    const auto& [label, corners] = rows.arms[i];
    figure.data += fmt::format("\n\n# {}: x, y, z [cm]\n", one_line(label));
    for (const Corner& corner : corners) figure.data += data_row({corner[0], corner[1], corner[2]});
    see(corners);
    add(label, fmt::format("{} using 1:2:3 with linespoints lw 1.8 pt 7 ps 0.45 lc rgb shade({})", i + 1, i % 3 + 1));
  }
  const std::size_t n = rows.targets.size();
  const std::string every = n > 200 ? fmt::format(" every {}", n / 100) : "";
  add("target", "0" + every + " using 1:2:3 with points pt 7 ps 0.35 lc rgb ink");
  add(rows.reached_label,
      fmt::format("0{} using 4:5:6 with points pt 6 ps 0.8 lw 0.8 {}", every, colour_of(rows.style)));
  if (!rows.late_or_too_fast.empty()) {
    figure.data += "\n\n# late or too fast: x, y, z [cm]\n";
    for (const Corner& corner : rows.late_or_too_fast) figure.data += data_row({corner[0], corner[1], corner[2]});
    add("late or too fast",
        fmt::format("{} using 1:2:3 with points pt 2 ps 0.9 lw 1.2 lc rgb '#D62728'", 1 + rows.arms.size()));
  }
  add_legend(figure, clauses.size());
  add_cube(figure, low, high);
  figure.plot = fmt::format("splot {}", fmt::join(clauses, ", \\\n  "));
  return figure;
}

std::optional<Figure> joints(const About& about, const JointRows& all_rows) {
  const auto& [rows, columns] = all_rows;
  Figure figure{.name = about.name, .caption = about.caption};
  const std::size_t drawn = drawn_of(rows, most_lines, figure).size();
  std::vector<double> all;
  std::size_t points = 1;
  bool is_outside = false;
  figure.settings += fmt::format("array name[{0}]\narray lower[{0}]\narray upper[{0}]\n", columns.size());
  const auto limit = [](double degrees) { return std::abs(degrees) <= 1e300 ? text_of(degrees) : "NaN"; };
  for (std::size_t i = 0; i < columns.size(); ++i)
    figure.settings +=
        fmt::format("name[{0}] = {1}\nlower[{0}] = {2}\nupper[{0}] = {3}\n", i + 1, gnuplot_text(columns[i].label),
                    limit(columns[i].lower_deg), limit(columns[i].upper_deg));
  figure.settings += fmt::format("array solver[{0}]\narray style[{0}]\n", drawn);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const JointRow& row = rows[i];
    figure.data += fmt::format("{}# {}: point, angle of each joint [deg]\n", i == 0 ? "" : "\n\n", one_line(row.label));
    for (std::size_t point = 0; point < row.angles_deg.size(); ++point) {
      figure.data += fmt::format("{} {}", point + 1, data_row(row.angles_deg[point]));
      for (std::size_t joint = 0; i < drawn && joint < columns.size(); ++joint) {
        const double angle = row.angles_deg[point][joint];
        if (!std::isnan(angle)) all.push_back(angle);
        is_outside = is_outside || angle < columns[joint].lower_deg || angle > columns[joint].upper_deg;
      }
    }
    if (row.angles_deg.empty()) figure.data += "NaN NaN\n";
    if (i >= drawn) continue;
    points = std::max(points, row.angles_deg.size());
    const std::string label = fmt::format("({}) {}", static_cast<char>('a' + i), row.label);
    figure.settings += fmt::format("solver[{0}] = {1}\nstyle[{0}] = {2}\n", i + 1,
                                   gnuplot_text(rows.size() == 1 ? "" : label), row.style);
  }
  if (all.empty()) return std::nullopt;
  if (is_outside) figure.caption += " Rings mark angles outside the limits.";
  const double panel_cm = drawn <= 2 ? 2.6 : 1.2, gap_cm = drawn == 1 ? 0 : 0.5;
  figure.height_cm = 1.6 + static_cast<double>(drawn) * (panel_cm + gap_cm);
  const double span = std::ranges::max(all) - std::ranges::min(all);
  figure.settings += title_of('x', "point") + title_of('y', "angle [deg]") +
                     linear_axis('y', all, "", Begins::around).settings +
                     fmt::format(
                         "set xrange [0:{0}]\nset xtics (1, {1})\nset ytics {2}\nset tics scale 0.4\n"
                         "set samples 2\nunset key\n",
                         points + 1, points, text_of(angle_step(span)));
  figure.plot = fmt::format(joint_panels, drawn, columns.size(), text_of(gap_cm), drawn == 1 ? 0.7 : 1.9,
                            points < 1000 ? "0.25" : "0.5");
  return figure;
}

std::optional<Figure> overview(const About& about, const std::string& x_axis, const std::vector<Dot>& dots) {
  Figure figure{.name = about.name, .caption = about.caption};
  std::vector<double> xs, ys;
  std::vector<std::string> clauses, left_out;
  std::vector<Named> names;
  figure.data = fmt::format("# one line per solver: {}; {}; both as in the paper\n", x_axis, about.axis());
  for (const Dot& dot : dots) {
    if (!std::isfinite(dot.x + dot.y)) {
      left_out.push_back(dot.label);
      continue;
    }
    xs.insert(xs.end(), {dot.x, dot.printed_x});
    ys.insert(ys.end(), {dot.y, dot.printed_y});
    figure.data += fmt::format("# {}\n{}", one_line(dot.label), data_row({dot.x, dot.y, dot.printed_x, dot.printed_y}));
    const std::string line = fmt::format("data every ::{0}::{0} using", names.size()), colour = colour_of(dot.style);
    names.push_back({dot.label, dot.style, dot.y, dot.x});
    clauses.push_back(fmt::format("{} (place_x($1)):(place_y($2)) with points ls {} dt 1 ps 0.9", line, dot.style));
    clauses.push_back(fmt::format("{} (place_x($3)):(place_y($4)) with points pt 6 ps 0.9 lw 1.2 {}", line, colour));
  }
  if (names.size() < 2) return std::nullopt;  // nothing to compare with
  if (!left_out.empty()) figure.caption += fmt::format(" Without {}.", names_of(left_out));
  const Axis x = linear_axis('x', xs, x_axis, Begins::at_zero), y = value_axis('y', ys, about, Begins::at_zero);
  figure.settings = x.settings + y.settings;
  clauses.insert(
      clauses.begin(),
      fmt::format("data using (place_x($1)):(place_y($2)):(place_x($3)-place_x($1)):(place_y($4)-place_y($2)) "
                  "with vectors nohead lw 0.6 {}",
                  grey));
  for (Named& name : names) {
    name.x = x.share_of(name.x);
    name.y = y.share_of(name.y);
  }
  add_names(figure, names);
  figure.plot = plotted(clauses);
  return figure;
}

}  // namespace ikbench::figures
