#include "analysis/figures/figure_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
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

void add_legend(Figure& figure, const std::vector<std::string>& labels) {
  std::size_t longest = 1;
  for (const std::string& label : labels) longest = std::max(longest, character_count(shortened(label, longest_label)));
  if (labels.size() > 8) figure.width_cm = two_columns_cm;
  // The largest width that gnuplot 5.4 reserves for an entry in an SVG: if it does not fit, it makes only one column.
  const double column_cm = 1.3 + 0.2 * static_cast<double>(longest);
  const auto columns = std::max<std::size_t>(1, static_cast<std::size_t>(figure.width_cm / column_cm));
  const std::size_t rows = (labels.size() + columns - 1) / columns;
  figure.settings += fmt::format("set key maxcols columns({})\n", text_of(column_cm));
  figure.height_cm += 0.3 + 0.36 * static_cast<double>(rows);
}

std::string point_axis(int points) {
  const double step = points <= 10 ? 1 : round_step(points, 5);
  return fmt::format("set xlabel 'point'\nset xrange [0.5:{}.5]\nset xtics {}\n{}", points, step,
                     step > 1 ? "set xtics add ('1' 1)\n" : "");
}

std::string lines_by_point(const std::map<int, std::vector<double>>& values) {
  std::string lines;
  for (const auto& [point, row] : values) {
    lines += fmt::to_string(point);
    for (const double value : row) lines += ' ' + data_number(value);
    lines += '\n';
  }
  return lines;
}

std::string plot_command(const std::vector<std::string>& clauses, std::string_view command) {
  return fmt::format("{} {}", command, fmt::join(clauses, ", \\\n  "));
}

std::vector<double> averages_by_point(const StudyResults& study, const std::string& solver, Metric metric) {
  std::vector<std::vector<double>> values(static_cast<std::size_t>(study.points));
  for (const Solve& solve : solves_of(study, solver)) {
    values[static_cast<std::size_t>(solve.point) - 1].push_back(value_of(study, solve, metric));
  }
  std::vector<double> averages;
  for (const auto& at_point : values) averages.push_back(average_of(metric)(at_point));
  return averages;
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
