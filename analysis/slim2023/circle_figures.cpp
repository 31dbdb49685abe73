#include "analysis/slim2023/circle_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "analysis/figures/arm.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/definition.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;
using namespace report;

namespace {

constexpr std::string_view grey_rings = "pt 6 ps 0.9 lc rgb '#999999'";
constexpr std::array<int, 3> arm_colours{2, 3, 4};  // of the style's; as many arms are drawn

// The solver that figures 14 to 16 are of.
const std::string& shown_solver(const StudyResults& study) { return study.solves.front().solver; }

double cm(const std::vector<double>& position_m, std::size_t axis) {
  return position_m.size() == 3 ? 100 * position_m[axis] : not_defined;
}

std::string row(std::initializer_list<double> values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(data_number(value));
  return fmt::format("{}\n", fmt::join(texts, " "));
}

std::string largest_error(const StudyResults& study) {
  double largest = 0;
  for (const auto& [point, solve] : first_run(study, shown_solver(study))) {
    const double error = solve->position_error_cm;
    largest = std::isfinite(error) ? std::max(largest, error) : not_defined;
  }
  return std::isfinite(largest) ? fmt::format(" The largest error is {} cm.", rounded_number(largest, 2))
                                : " Some of its answers are not finite.";
}

// Targets and where the arm came to, x, y, z [cm].
std::string points_data(const StudyResults& study) {
  std::string data = "# target x, y, z [cm]; reached x, y, z [cm]; point; position error [cm] of " +
                     one_line(shown_solver(study)) + "\n";
  for (const auto& [point, solve] : first_run(study, shown_solver(study))) {
    const auto& target = solve->target_position_m;
    const auto& reached = solve->reached_position_m;
    data += row({cm(target, 0), cm(target, 1), cm(target, 2), cm(reached, 0), cm(reached, 1), cm(reached, 2),
                 static_cast<double>(point), solve->position_error_cm});
  }
  return data;
}

// The circle itself as the definition has it; where it does not, the polygon through the targets.
std::string circle_data(const StudyResults& study) {
  const Definition definition(study.definition);
  const std::vector<double> centre = definition.numbers("/path/centre_cm");
  const double radius = definition.number("/path/radius_cm");
  std::string data = "\n\n# the circle: x, y, z [cm]\n";
  if (centre.size() == 3 && std::isfinite(radius)) {
    constexpr int corners = 120;
    for (int i = 0; i <= corners; ++i) {
      const double t = 2 * std::numbers::pi * i / corners;
      data += row({centre[0] + radius * std::cos(t), centre[1] + radius * std::sin(t), centre[2]});
    }
    return data;
  }
  std::string first;
  for (const auto& [point, solve] : first_run(study, shown_solver(study))) {
    const auto& target = solve->target_position_m;
    data += row({cm(target, 0), cm(target, 1), cm(target, 2)});
    if (first.empty()) first = row({cm(target, 0), cm(target, 1), cm(target, 2)});
  }
  return data + first;
}

// Targets and where the arm came to, of the columns that are named.
std::string points_clauses(const std::string& target, const std::string& reached) {
  return fmt::format(
      "'' index 0 using {} with points pt 7 ps 0.35 lc rgb '#000000' title 'target', \\\n"
      "  '' index 0 using {} with points pt 6 ps 0.9 lw 0.9 lc rgb '#0072B2' title 'reached'",
      target, reached);
}

// The arm at some of the points, evenly along the path.
std::map<int, std::vector<Point>> arms(const StudyResults& study) {
  const Definition definition(study.definition);
  const auto solves = first_run(study, shown_solver(study));
  const std::size_t step = (solves.size() + arm_colours.size() - 1) / arm_colours.size();
  std::map<int, std::vector<Point>> result;
  std::size_t index = 0;
  for (const auto& [point, solve] : solves) {
    if (index++ % step != 0) continue;
    std::vector<Point> corners = arm_points(definition, solve->answer_rad);
    if (!corners.empty()) result.emplace(point, std::move(corners));
  }
  return result;
}

// 0 where it is not finite.
Point mean_target_cm(const StudyResults& study) {
  Point result{};
  for (std::size_t axis = 0; axis < result.size(); ++axis) {
    std::vector<double> values;
    for (const auto& [point, solve] : first_run(study, shown_solver(study))) {
      values.push_back(cm(solve->target_position_m, axis));
    }
    if (const double middle = mean(values); std::isfinite(middle)) result[axis] = middle;
  }
  return result;
}

// Best error after every iteration, mean over the solves; a solve that ended earlier keeps its last.
std::vector<double> mean_trace(const StudyResults& study, const std::string& solver) {
  std::vector<const std::vector<double>*> traces;
  std::size_t iterations = 0;
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver != solver || solve.trace_cm.empty()) continue;
    traces.push_back(&solve.trace_cm);
    iterations = std::max(iterations, solve.trace_cm.size());
  }
  std::vector<double> result(iterations), at_iteration(traces.size());
  for (std::size_t i = 0; i < iterations; ++i) {
    for (std::size_t t = 0; t < traces.size(); ++t) {
      at_iteration[t] = (*traces[t])[std::min(i, traces[t]->size() - 1)];
    }
    result[i] = mean(at_iteration);
  }
  return result;
}

// The farthest target's distance from the base times the spacing of numbers at 1: the order of
// rounding. An answer may come nearer by chance.
double order_of_rounding_cm(const StudyResults& study) {
  double farthest = 0;
  for (const SolveRecord& solve : study.solves) {
    const double distance =
        std::hypot(cm(solve.target_position_m, 0), cm(solve.target_position_m, 1), cm(solve.target_position_m, 2));
    if (std::isfinite(distance)) farthest = std::max(farthest, distance);
  }
  return farthest * std::numeric_limits<double>::epsilon();
}

}  // namespace

Figure circle_plane_figure(const StudyResults& study) {
  Figure figure{
      .name = "figure-14",
      .caption = fmt::format("Circle, its points (dots) and positions that {} reached in its first run (rings).{}",
                             shown_solver(study), largest_error(study)),
      .height_cm = 8.2};
  figure.data = points_data(study) + circle_data(study) + "\n\n# labels: x, y [cm], point\n";
  const auto solves = first_run(study, shown_solver(study));
  std::array<std::vector<double>, 2> drawn, targets;
  for (const auto& [point, solve] : solves) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      targets[axis].push_back(cm(solve->target_position_m, axis));
      for (const double at : {targets[axis].back(), cm(solve->reached_position_m, axis)}) {
        if (std::isfinite(at)) drawn[axis].push_back(at);
      }
    }
  }
  // A square around all of it; labels stand outside of the circle.
  std::array<double, 2> middle{};
  double half = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (drawn[axis].empty()) continue;
    const auto [low, high] = std::ranges::minmax(drawn[axis]);
    middle[axis] = low / 2 + high / 2;
    half = std::max(half, 0.65 * (high - low));
  }
  if (!(half > 0) || !std::isfinite(half)) half = 1;
  std::size_t index = 0;
  for (const auto& [point, solve] : solves) {
    const double x = targets[0][index], y = targets[1][index];
    if (index++ % ((solves.size() + 3) / 4) != 0) continue;
    const double away = std::hypot(x - middle[0], y - middle[1]);
    const double out = away > 0 ? 1 + 0.12 * half / away : 1;
    figure.data +=
        row({middle[0] + out * (x - middle[0]), middle[1] + out * (y - middle[1]), static_cast<double>(point)});
  }
  figure.settings = fmt::format(
      "set size ratio -1\nset xlabel 'x [cm]'\nset ylabel 'y [cm]'\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
      text_of(middle[0] - half), text_of(middle[0] + half), text_of(middle[1] - half), text_of(middle[1] + half));
  add_legend(figure, {"circle", "target", "reached"});
  figure.plot =
      plot_command({"'figure-14.dat' index 1 using 1:2 with lines lw 0.7 lc rgb '#888888' title 'circle'",
                    points_clauses("1:2", "4:5"), "'' index 2 using 1:2:(sprintf('%d', $3)) with labels notitle"});
  return figure;
}

Figure circle_space_figure(const StudyResults& study) {
  const std::map<int, std::vector<Point>> drawn = arms(study);
  std::vector<int> shown;
  for (const auto& [point, corners] : drawn) shown.push_back(point);
  Figure figure{
      .name = "figure-15",
      .caption = fmt::format(
          "Circle in space, its points (dots) and positions that {} reached in its first run (rings){}.{}",
          shown_solver(study), shown.empty() ? "" : fmt::format(", with the arm at points {}", fmt::join(shown, ", ")),
          largest_error(study)),
      .height_cm = 8.0};
  figure.data = points_data(study) + circle_data(study);
  std::array<std::vector<double>, 3> coordinates;
  const Point middle = mean_target_cm(study);
  std::vector<std::string> clauses;
  for (const auto& [point, corners] : drawn) {
    figure.data += fmt::format("\n\n# the arm at point {}, from the base to the tool: x, y, z [cm]\n", point);
    for (const Point& corner : corners) {
      for (std::size_t axis = 0; axis < 3; ++axis) coordinates[axis].push_back(100 * corner[axis]);
      figure.data += row({100 * corner[0], 100 * corner[1], 100 * corner[2]});
    }
    const int colour = arm_colours[clauses.size()];
    const Point& tool = corners.back();
    const auto outside = [&](std::size_t axis) {
      return text_of(middle[axis] + 1.45 * (100 * tool[axis] - middle[axis]));
    };
    figure.settings += fmt::format("set label '{}' at {}, {}, {} center tc rgb word(colours, {}) front\n", point,
                                   outside(0), outside(1), outside(2), colour);
    clauses.push_back(
        fmt::format("'figure-15.dat' index {} using 1:2:3 with linespoints lw 1.5 pt 7 ps 0.45 lc rgb "
                    "word(colours, {})",
                    clauses.size() + 2, colour));
  }
  for (const auto& [point, solve] : first_run(study, shown_solver(study))) {
    for (const auto* position : {&solve->target_position_m, &solve->reached_position_m}) {
      if (!std::isfinite(cm(*position, 0) + cm(*position, 1) + cm(*position, 2))) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) coordinates[axis].push_back(cm(*position, axis));
    }
  }
  figure.settings += space_axes(coordinates) + "unset key\n";
  clauses.push_back("'figure-15.dat' index 1 using 1:2:3 with lines lw 0.7 lc rgb '#888888'");
  clauses.push_back(points_clauses("1:2:3", "4:5:6"));
  figure.plot = plot_command(clauses, "splot");
  return figure;
}

Figure circle_joints_figure(const StudyResults& study) {
  const auto solves = first_run(study, shown_solver(study));
  const Definition definition(study.definition);
  std::vector<double> lower, upper;  // [deg]
  if (const std::optional<Arm> arm = arm_of(definition)) {
    for (const ArmLink& link : arm->links) {
      if (!std::isfinite(link.lower) || !std::isfinite(link.upper)) break;
      lower.push_back(link.lower * 180 / std::numbers::pi);
      upper.push_back(link.upper * 180 / std::numbers::pi);
    }
  }
  const std::vector<PrintedPosture> printed = printed_table_8(study.published);
  std::size_t joints = 0;
  for (const auto& [point, solve] : solves) joints = std::max(joints, solve->answer_rad.size());

  Figure figure{.name = "figure-16",
                .caption = fmt::format("Joint angles along the circle, first run of {}.", shown_solver(study))};
  std::vector<double> all;
  figure.data = "# point, then the angle of each joint [deg]\n";
  for (const auto& [point, solve] : solves) {
    figure.data += fmt::to_string(point);
    for (std::size_t joint = 0; joint < joints; ++joint) {
      const double angle = joint < solve->answer_rad.size() ? solve->answer_rad[joint] : not_defined;
      all.push_back(angle * 180 / std::numbers::pi);
      figure.data += ' ' + data_number(all.back());
    }
    figure.data += '\n';
  }
  std::vector<std::string> clauses{"NaN notitle"}, labels;
  if (!printed.empty()) {
    figure.caption += " Grey: as printed.";
    figure.data += "\n\n# as printed: point, then the angle of each joint [deg]\n";
    for (const PrintedPosture& posture : printed) {
      figure.data += fmt::format("{} {} {} {}\n", posture.point, posture.angles_deg[0], posture.angles_deg[1],
                                 posture.angles_deg[2]);
      all.insert(all.end(), posture.angles_deg.begin(), posture.angles_deg.end());
    }
    for (int joint = 1; joint <= 3; ++joint) {
      clauses.push_back(fmt::format("'{}.dat' index 1 using 1:{} with points {} {}", figure.name, joint + 1, grey_rings,
                                    joint == 1 ? "title 'as printed'" : "notitle"));
    }
  }
  for (std::size_t joint = 1; joint <= joints; ++joint) {
    labels.push_back(fmt::format("joint {}", joint));
    clauses.push_back(fmt::format("'{}.dat' index 0 using 1:{} with linespoints ls {} title '{}'", figure.name,
                                  joint + 1, joint, labels.back()));
  }
  const std::size_t limited = std::min({joints, lower.size(), upper.size()});
  if (limited > 0) figure.caption += " Dashed: joint limits, in the colour of the joint.";
  for (std::size_t joint = 0; joint < limited; ++joint) {
    for (const double limit : {lower[joint], upper[joint]}) {
      if (!std::isfinite(limit)) continue;
      all.push_back(limit);
      figure.settings += fmt::format(
          "set arrow from graph 0, first {0} to graph 1, first {0} nohead lw 0.7 dt 2 lc rgb word(colours, {1})\n",
          text_of(limit), joint % 7 + 1);
    }
  }
  std::erase_if(all, [](double angle) { return !std::isfinite(angle); });
  if (all.empty()) {
    figure.settings += "set yrange [-180:180]\nset label 'no finite values' at graph 0.5, graph 0.5 center\n";
  } else {
    const auto [smallest, largest] = std::ranges::minmax(all);
    const double margin = std::max(5.0, 0.05 * (largest - smallest));
    figure.settings += fmt::format("set yrange [{}:{}]\n", text_of(smallest - margin), text_of(largest + margin));
    if (largest - smallest <= 400) figure.settings += "set ytics 30\n";
  }
  figure.settings += "set ylabel 'joint angle [deg]'\n" + point_axis(study.points);
  labels.push_back("as printed");
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

Figure circle_errors_figure(const StudyResults& study) {
  Figure figure{.name = "figure-17", .caption = "Position error [cm] at each point of the circle, mean over the runs."};
  std::vector<std::vector<double>> curves;
  std::vector<double> all;
  for (const std::string& solver : study.solvers) {
    curves.push_back(means_by_point(study, solver, Metric::position_error_cm));
    all.insert(all.end(), curves.back().begin(), curves.back().end());
  }
  figure.data = "# column 1: point; then the position error [cm], mean over the runs, of\n";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    figure.data += fmt::format("# column {}: {}\n", i + 2, one_line(study.solvers[i]));
  }
  for (std::size_t point = 0; point < static_cast<std::size_t>(study.points); ++point) {
    figure.data += fmt::to_string(point + 1);
    for (const auto& curve : curves) figure.data += ' ' + data_number(curve[point]);
    figure.data += '\n';
  }
  std::vector<std::string> clauses{"NaN notitle"}, labels;
  if (const std::vector<PrintedPosture> printed = printed_table_8(study.published); !printed.empty()) {
    figure.caption += " Grey: as printed.";
    figure.data += "\n\n# as printed: point, error [cm]\n";
    for (const PrintedPosture& posture : printed) {
      figure.data += fmt::format("{} {}\n", posture.point, posture.error_cm);
      all.push_back(posture.error_cm);
    }
    labels.emplace_back("as printed");
    clauses.push_back(fmt::format("'{}.dat' index 1 using 1:(shown($2)) with linespoints lw 0.7 dt 2 {} title '{}'",
                                  figure.name, grey_rings, labels.back()));
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    labels.push_back(shortened(study.solvers[i], longest_label));
    clauses.push_back(fmt::format("'{}.dat' index 0 using 1:(shown(${})) with linespoints ls {} title {}", figure.name,
                                  i + 2, i + 1, gnuplot_string(labels.back())));
  }
  const Axis axis = value_axis(all, quantity(Metric::position_error_cm), Scale::logarithmic);
  figure.caption = with_notes(figure.caption, study, Metric::position_error_cm, axis);
  figure.settings = axis.settings + point_axis(study.points);
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

Figure convergence_figure(const StudyResults& study) {
  const double rounding_cm = order_of_rounding_cm(study);
  Figure figure{
      .name = "figure-18",
      .caption = fmt::format(
          "Best position error [cm] after every iteration, mean over all solves; solves that stop early keep their "
          "last error. Dashed: {} cm, the rounding level (2^-52 of the farthest target's distance from the base).",
          rounded_number(rounding_cm, 2))};
  std::vector<double> all;
  if (rounding_cm > 0) all.push_back(rounding_cm);
  std::vector<std::string> clauses, labels;
  std::size_t iterations = 1;
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    const std::vector<double> curve = mean_trace(study, study.solvers[i]);
    if (curve.empty()) continue;
    figure.data += fmt::format("{}# {}\n# iteration, mean of the best position error [cm]\n",
                               figure.data.empty() ? "" : "\n\n", one_line(study.solvers[i]));
    for (std::size_t k = 0; k < curve.size(); ++k) figure.data += row({static_cast<double>(k + 1), curve[k]});
    all.insert(all.end(), curve.begin(), curve.end());
    iterations = std::max(iterations, curve.size());
    labels.push_back(shortened(study.solvers[i], longest_label));
    clauses.push_back(fmt::format("'{}.dat' index {} using 1:(shown($2)) with lines ls {} lw 1.3 title {}", figure.name,
                                  clauses.size(), i + 1, gnuplot_string(labels.back())));
  }
  const Axis axis = value_axis(all, "average position error [cm]", Scale::logarithmic);
  figure.caption = with_notes(figure.caption, study, Metric::position_error_cm, axis);
  figure.settings =
      axis.settings + fmt::format("set xlabel 'iteration'\nset xrange [0:{}]\n", std::max<std::size_t>(iterations, 2));
  if (rounding_cm > 0) {
    labels.emplace_back("rounding level");
    clauses.push_back(
        fmt::format("{} with lines lw 0.9 dt 2 lc rgb '#777777' title 'rounding level'", text_of(rounding_cm)));
  }
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

std::vector<Figure> circle_figures(const StudyResults& study) {
  if (study.solves.empty() || !is_circle(study)) return {};
  std::vector<Figure> figures{circle_plane_figure(study), circle_space_figure(study), circle_joints_figure(study),
                              circle_errors_figure(study)};
  const auto is_traced = [](const SolveRecord& solve) { return !solve.trace_cm.empty(); };
  if (std::ranges::any_of(study.solves, is_traced)) figures.push_back(convergence_figure(study));
  return figures;
}

}  // namespace ikbench::slim2023
