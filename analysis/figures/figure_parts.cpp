#include "analysis/figures/figure_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"
#include "numerics/units.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;

std::string tick_label(std::string_view text) {
  std::string doubled;
  for (const char c : text) doubled.append(c == '%' ? 2 : 1, c);
  return gnuplot_string(doubled);
}

std::string value_words(Metric metric, double value) {
  const MetricInfo& info = info_of(metric);
  const bool is_milliseconds = info.unit == "s" && std::abs(value) < 0.1;
  const std::string number = short_number(is_milliseconds ? 1000 * value : value);
  return info.unit.empty() || !std::isfinite(value) ? number
                                                    : fmt::format("{} {}", number, is_milliseconds ? "ms" : info.unit);
}

std::string data_number(double value) { return std::isfinite(value) ? text_of(value) : "NaN"; }

std::string data_line(const std::vector<double>& values) {
  std::string line;
  for (const double value : values) line += (line.empty() ? "" : " ") + data_number(value);
  return line + '\n';
}

std::string with_notes(std::string caption, const StudyResults& study, Metric metric, const Axis& axis) {
  if (axis.shows_at_edge) {
    caption += axis.least > 0 ? fmt::format(" Values up to {}, which are rounding, are drawn at the lower edge.",
                                            rounded_number(axis.least, 3))
                              : " Values of zero are drawn at the lower edge.";
  }
  if (info_of(metric).kind == Kind::time) {
    if (const std::string note = words_of(times_doubts(study)); !note.empty()) caption += ' ' + note;
  }
  return caption;
}

double label_cm(std::string_view label) {
  constexpr std::string_view narrow = "fijlrt.,:;|!'()[] -", wide = "mwMW@%";
  double cm = 0;
  for (const char c : label) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80) continue;  // not the first byte of a character
    const bool is_wide = wide.find(c) != std::string_view::npos || byte >= 0xE3, is_capital = c >= 'A' && c <= 'Z';
    cm += narrow.find(c) != std::string_view::npos ? 0.09 : is_wide ? 0.25 : is_capital ? 0.17 : 0.14;
  }
  return cm;
}

void add_rows(Figure& figure, const std::vector<std::string>& labels, double row_cm) {
  constexpr std::size_t longest = 2 * longest_label + 3;  // two names in a row of a comparison
  std::vector<std::string> ticks;
  double widest_cm = 0;
  for (const std::string& name : labels) {
    const std::string label = row_label(name, longest);
    widest_cm = std::max(widest_cm, label_cm(label));
    ticks.push_back(fmt::format("{} {}", tick_label(label), ticks.size() + 1));
  }
  const std::size_t rows = std::max<std::size_t>(labels.size(), 1);
  if (widest_cm > 2.8) figure.width_cm = two_columns_cm;
  figure.height_cm = 1.4 + row_cm * static_cast<double>(rows);
  figure.settings += fmt::format(
      "unset key\nset yrange [{}.5:0.5]\nset ytics noenhanced ({}) font names\nset border 1\nset ytics scale 0\n"
      "set grid noytics\nset xtics enhanced\nrows_margin = margin({})\nset lmargin at screen rows_margin\n",
      rows, fmt::join(ticks, ", "), text_of(widest_cm + 0.35));
  if (labels.empty()) figure.settings += "unset ytics\nset label 'nothing to show' at graph 0.5, graph 0.5 center\n";
}

void add_legend(Figure& figure, const std::vector<std::string>& labels) {
  std::size_t longest = 1;
  for (const std::string& label : labels) longest = std::max(longest, character_count(shortened(label, longest_label)));
  if (labels.size() > 8) figure.width_cm = two_columns_cm;
  // The largest width that gnuplot 5.4 reserves for an entry in an SVG: if it does not fit, it makes only one column.
  figure.legend = labels.size();
  figure.legend_cm = 1.3 + 0.2 * static_cast<double>(longest);
  figure.settings += "set key maxcols columns(legend_cm)\n";
}

std::string point_axis(int points) {
  const double step = points <= 10 ? 1 : round_step(points, 5);
  return fmt::format("set xlabel 'point'\nset xrange [0.5:{}.5]\nset xtics {}\n{}shown_x(x) = x\n", points, step,
                     step > 1 ? "set xtics add ('1' 1)\n" : "");
}

std::string lines_by_point(const std::map<int, std::vector<double>>& values) {
  std::string lines;
  for (const auto& [point, row] : values) lines += fmt::format("{} {}", point, data_line(row));
  return lines;
}

std::string plot_command(const std::vector<std::string>& clauses, std::string_view command) {
  return fmt::format("{} {}", command, fmt::join(clauses, ", \\\n  "));
}

void Curve::add(double x, const Estimate& y) {
  rows += data_line({x, y.value, y.low, y.high});
  ++count;
}

std::vector<std::string> add_curves(Figure& figure, const StudyResults& study, const std::vector<Curve>& curves,
                                    std::vector<std::string> clauses, std::string_view with) {
  std::vector<std::string> lines, labels;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i];
    const std::size_t place = place_of(study, study.solvers[i]);
    const int style = style_of(study, study.solvers[i]);
    labels.push_back(shortened(study.solvers[i], longest_label) + (curve.count == 0 ? " (nothing to show)" : ""));
    figure.data += fmt::format("{}# {}\n{}", i == 0 ? "" : "\n\n", one_line(study.solvers[i]),
                               curve.count == 0 ? "NaN NaN NaN NaN\n" : curve.rows);
    if (curve.band < curve.count && study.solvers.size() <= most_bands) {
      clauses.push_back(
          fmt::format("data index {} every ::{} using (shown_x($1)):(shown($3)):(shown($4)) with filledcurves ls {} "
                      "fillstyle transparent solid 0.13 noborder",
                      i, curve.band, style));
    }
    const std::string title = gnuplot_string(labels.back());
    const auto add = [&](std::string_view every, std::string_view as) {
      lines.push_back(fmt::format("data index {}{} using (shown_x($1)):(shown($2)) with {}", i, every, as));
    };
    if (curve.count > 0 && !with.empty()) {
      add("", fmt::format("{} ls {} pointinterval {} title {}", with, style, 1 + curve.count / 40, title));
      continue;
    }
    if (curve.count > 0) {
      const std::size_t interval = std::max<std::size_t>(1, curve.count / 9);
      add("", fmt::format("lines ls {}", style));
      add(fmt::format(" every {}::{}", interval, std::min(curve.count - 1, 1 + place * 5 % interval)),
          fmt::format("points ls {} dt 1", style));
    }
    lines.push_back(fmt::format("keyentry with {} ls {} title {}", with.empty() ? "linespoints" : with, style, title));
  }
  clauses.insert(clauses.begin(), "NaN");
  clauses.insert(clauses.end(), lines.begin(), lines.end());
  figure.plot = plot_command(clauses);
  return labels;
}

std::vector<std::vector<double>> values_by_point(const StudyResults& study, const std::string& solver, Metric metric) {
  std::vector<std::vector<double>> values(static_cast<std::size_t>(study.points));
  for (const Solve& solve : solves_of(study, solver)) {
    values[static_cast<std::size_t>(solve.point) - 1].push_back(value_of(study, solve, metric));
  }
  return values;
}

std::map<int, const SolveRecord*> first_run(const StudyResults& study, const std::string& solver) {
  std::map<int, const SolveRecord*> solves;
  for (const SolveRecord& solve : study.solve_data->drawn) {
    if (solve.solver == solver) solves[solve.point] = &solve;
  }
  return solves;
}

std::map<int, std::vector<double>> joint_angles_deg(const std::map<int, const SolveRecord*>& solves) {
  std::size_t joints = 0;
  for (const auto& [point, solve] : solves) joints = std::max(joints, solve->answer_rad.size());
  std::map<int, std::vector<double>> angles;
  for (const auto& [point, solve] : solves) {
    for (const double angle : solve->answer_rad) angles[point].push_back(angle / degree);
    angles[point].resize(joints, not_defined);
  }
  return angles;
}

std::string space_axes(const std::array<std::vector<double>, 3>& coordinates_cm) {
  double longest = 0;
  std::array<double, 3> centre{};
  for (std::size_t axis = 0; axis < coordinates_cm.size(); ++axis) {
    if (coordinates_cm[axis].empty()) continue;
    const auto [low, high] = std::ranges::minmax(coordinates_cm[axis]);
    centre[axis] = (low + high) / 2;
    longest = std::max(longest, high - low);
  }
  const double half = longest > 0 ? 0.55 * longest : 1;
  std::string settings;
  for (std::size_t axis = 0; axis < coordinates_cm.size(); ++axis) {
    settings +=
        fmt::format("set {0}range [{1}:{2}]\nset {0}tics {3} offset 0, 0\n", "xyz"[axis], text_of(centre[axis] - half),
                    text_of(centre[axis] + half), text_of(round_step(2 * half, 5)));
  }
  return settings +
         "set xlabel 'x [cm]' offset -1, 0.3\nset ylabel 'y [cm]'\nset zlabel 'z [cm]' rotate parallel offset 1, 0\n"
         "set view 62, 32, 1\nset view equal xyz\nset xyplane relative 0\nset border 127 lw 0.5 lc rgb '#AAAAAA'\n"
         "set tics textcolor rgb '#000000'\nset grid xtics ytics ztics\n";
}

}  // namespace ikbench::figures
