#include "analysis/slim2023/circle_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "analysis/figures/arm.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/circle_curves.hpp"
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

constexpr std::array<int, 3> arm_colours{2, 3, 4};  // line styles, one per drawn arm

// The solver that figures 14 to 16 show.
const std::string& shown_solver(const StudyResults& study) { return solver_of(study, study.solves.front()); }

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

// Targets and reached points, x, y, z [cm].
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

// The circle of the definition; if it has none, the polygon through the targets.
std::string circle_data(const StudyResults& study) {
  const std::vector<double>& centre = study.facts.path.centre_cm;
  const double radius = study.facts.path.radius_cm;
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

// Plot clauses for targets and reached points, from the named columns.
std::string points_clauses(const std::string& target, const std::string& reached) {
  return fmt::format(
      "'' index 0 using {} with points pt 7 ps 0.35 lc rgb '#000000' title 'target', \\\n"
      "  '' index 0 using {} with points pt 6 ps 0.9 lw 0.9 lc rgb word(colours, 1) title 'reached'",
      target, reached);
}

// The arm at some of the points, evenly along the path.
std::map<int, std::vector<Point>> arms(const StudyResults& study) {
  const auto solves = first_run(study, shown_solver(study));
  const std::size_t step = (solves.size() + arm_colours.size() - 1) / arm_colours.size();
  std::map<int, std::vector<Point>> result;
  std::size_t index = 0;
  for (const auto& [point, solve] : solves) {
    if (index++ % step != 0) continue;
    std::vector<Point> corners = arm_points(study.facts, solve->answer_rad);
    if (!corners.empty()) result.emplace(point, std::move(corners));
  }
  return result;
}

// The mean target [cm]; 0 if it is not finite.
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

std::vector<Figure> circle_figures(const StudyResults& study) {
  if (study.solves.empty() || !is_circle(study)) return {};
  std::vector<Figure> figures{circle_plane_figure(study), circle_space_figure(study), circle_joints_figure(study),
                              circle_errors_figure(study)};
  const auto is_traced = [](const Solve& solve) { return !trace_cm(solve).empty(); };
  if (std::ranges::any_of(study.solves, is_traced)) figures.push_back(convergence_figure(study));
  return figures;
}

}  // namespace ikbench::slim2023
