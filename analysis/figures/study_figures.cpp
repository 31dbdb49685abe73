#include "analysis/figures/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/definition.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;

namespace {

// 0 is a, 25 z, 26 aa.
std::string letters(std::size_t index) {
  std::string text(1, static_cast<char>('a' + index % 26));
  return index < 26 ? text : letters(index / 26 - 1) + text;
}

}  // namespace

Figure path_figure(const StudyResults& study, const std::string& name) {
  const std::string solver = study.solves.front().solver;
  const bool is_path = !Definition(study.definition).draws_targets();
  Figure figure{.name = name,
                .caption = fmt::format("Targets ({}dots) and positions that {} reached in its first run (rings).",
                                       is_path ? "line, " : "", solver),
                .height_cm = 8.0};
  figure.data = "# target x, y, z [cm]; reached x, y, z [cm] and position error [cm] of " + one_line(solver) + "\n";
  std::array<std::vector<double>, 3> coordinates;
  double largest_error = 0;
  for (const auto& [point, solve] : first_run(study, solver)) {
    if (solve->target_position_m.size() != coordinates.size()) continue;
    for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
      coordinates[axis].push_back(100 * solve->target_position_m[axis]);
      figure.data += data_number(coordinates[axis].back()) + ' ';
    }
    for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
      const bool known = solve->reached_position_m.size() == coordinates.size();
      figure.data += data_number(known ? 100 * solve->reached_position_m[axis] : not_defined) + ' ';
    }
    figure.data += data_number(solve->position_error_cm) + '\n';
    largest_error =
        std::isfinite(solve->position_error_cm) ? std::max(largest_error, solve->position_error_cm) : not_defined;
  }
  figure.caption += std::isfinite(largest_error)
                        ? fmt::format(" The largest error is {} cm.", rounded_number(largest_error, 2))
                        : " Some of its answers are not finite.";
  figure.settings = space_axes(coordinates) + "unset key\n";
  std::vector<std::string> clauses;
  const auto add = [&](std::string_view what) { clauses.push_back(fmt::format("'{}.dat' using {}", name, what)); };
  if (is_path) add("1:2:3 with lines lw 0.7 lc rgb '#888888'");
  add("1:2:3 with points pt 7 ps 0.35 lc rgb '#000000'");
  add("4:5:6 with points pt 6 ps 0.8 lw 0.8 lc rgb '#0072B2'");
  if (is_path) add("1:2:3:('start') every ::0::0 with labels right offset -0.9,0.4");
  figure.plot = plot_command(clauses, "splot");
  return figure;
}

Figure curves_figure(const StudyResults& study, Metric metric, const std::string& name,
                     const std::map<int, std::vector<double>>& printed) {
  Figure figure{.name = name};
  std::vector<std::vector<double>> curves;
  std::vector<double> all;
  for (const std::string& solver : study.solvers) {
    curves.push_back(averages_by_point(study, solver, metric));
    all.insert(all.end(), curves.back().begin(), curves.back().end());
  }
  std::vector<std::string> clauses{"NaN notitle"}, labels;
  if (!printed.empty()) {
    for (const auto& [point, values] : printed) all.insert(all.end(), values.begin(), values.end());
    labels.emplace_back("as printed");
    clauses.push_back(fmt::format("'{}.dat' index 1 using 1:(shown($2)) with linespoints lw 0.7 dt 2 {} title '{}'",
                                  figure.name, grey_rings, labels.back()));
  }
  labels.insert(labels.end(), study.solvers.begin(), study.solvers.end());
  const Axis axis =
      value_axis(all, quantity(metric), metric == Metric::position_error_cm ? Scale::logarithmic : Scale::by_spread);
  figure.caption = with_notes(fmt::format("{}: {} over the runs at each point.{}", capitalised(axis.quantity),
                                          average_name(metric), printed.empty() ? "" : " Grey: as printed."),
                              study, metric, axis);
  figure.settings = axis.settings + point_axis(study.points);
  add_legend(figure, labels);

  const int points_per_marker = 1 + study.points / 40;
  figure.data =
      fmt::format("# column 1: point; then {}, {} over the runs, of\n", quantity(metric), average_name(metric));
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    figure.data += fmt::format("# column {}: {}\n", i + 2, one_line(study.solvers[i]));
    const std::string label = shortened(study.solvers[i], longest_label);
    if (std::ranges::any_of(curves[i], [](double value) { return std::isfinite(value); })) {
      clauses.push_back(
          fmt::format("'{}.dat' index 0 using 1:(shown(${})) with linespoints ls {} pointinterval {} title {}",
                      figure.name, i + 2, i + 1, points_per_marker, gnuplot_string(label)));
    } else {  // in the legend all the same
      clauses.push_back(
          fmt::format("keyentry with linespoints ls {} title {}", i + 1, gnuplot_string(label + " (nothing to show)")));
    }
  }
  std::map<int, std::vector<double>> by_point;
  for (int point = 1; point <= study.points; ++point) {
    for (const auto& curve : curves) by_point[point].push_back(curve[static_cast<std::size_t>(point) - 1]);
  }
  figure.data += lines_by_point(by_point);
  if (!printed.empty()) figure.data += "\n\n# as printed: point, value\n" + lines_by_point(printed);
  figure.plot = plot_command(clauses);
  return figure;
}

std::vector<Figure> joint_figures(const StudyResults& study, const std::string& name) {
  std::vector<Figure> figures;
  for (const std::string& solver : study.solvers) {
    const auto solves = first_run(study, solver);
    if (solves.empty()) continue;
    Figure figure{
        .name = fmt::format("{}-{}", name, letters(figures.size())),
        .caption = fmt::format("Joint angles along the path, run {} of {}.", solves.begin()->second->run, solver)};
    const std::map<int, std::vector<double>> angles = joint_angles_deg(solves);
    const std::size_t joints = angles.begin()->second.size();
    double largest = 180;
    for (const auto& [point, of_joints] : angles) {
      for (const double angle : of_joints) {
        if (std::isfinite(angle)) largest = std::max(largest, std::abs(angle));
      }
    }
    figure.data = "# point, then the angle of each joint [deg]\n" + lines_by_point(angles);
    const double range = largest <= 180 ? 180 : 1.05 * largest;
    figure.settings = fmt::format(
        "set title {} noenhanced offset 0, -0.6\nset tmargin 2\nset ylabel 'joint angle [deg]'\nset yrange [{}:{}]\n{}",
        gnuplot_string(shortened(solver, 2 * longest_label)), -range, range, largest <= 180 ? "set ytics 60\n" : "");
    figure.settings += point_axis(study.points);
    std::vector<std::string> clauses;
    std::vector<std::string> labels;
    for (std::size_t joint = 1; joint <= joints; ++joint) {
      labels.push_back(fmt::format("joint {}", joint));
      clauses.push_back(fmt::format("'{}.dat' using 1:(${}) with linespoints ls {} title '{}'", figure.name, joint + 1,
                                    joint, labels.back()));
    }
    if (clauses.empty()) continue;
    add_legend(figure, labels);
    figure.plot = plot_command(clauses);
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace ikbench::figures
