#include "analysis/figures/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "analysis/figures/arm.hpp"
#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/share_curves.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/quantile.hpp"
#include "numerics/number.hpp"
#include "numerics/units.hpp"
#include "robots/robot.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace robots;
using namespace results;
using namespace statistics;
using namespace inference;

namespace {

// Three numbers [m] as a line [cm], which are also added to the coordinates that the axes show.
std::string line_of(const std::vector<double>& position_m, std::array<std::vector<double>, 3>& shown_cm) {
  std::string line;
  for (std::size_t axis = 0; axis < shown_cm.size(); ++axis) {
    const double cm = position_m.size() == shown_cm.size() ? 100 * position_m[axis] : not_defined;
    if (std::isfinite(cm)) shown_cm[axis].push_back(cm);
    line += data_number(cm) + ' ';
  }
  return line;
}

}  // namespace

Figure path_figure(const StudyResults& study, const std::string& name, View view) {
  const std::string solver = solver_of(study, study.solves.front());
  Figure figure{.name = name,
                .caption = fmt::format("Targets, and positions that {} reached in its first run.", solver),
                .height_cm = 8.0};
  figure.data = "# target x, y, z [cm]; reached x, y, z [cm] and position error [cm] of " + one_line(solver) + "\n";
  std::array<std::vector<double>, 3> coordinates, reached;  // the axes are not widened by what was reached
  double largest_error = 0;
  const auto solves = first_run(study, solver);
  std::string first;
  for (const auto& [point, solve] : solves) {
    const std::string line = line_of(solve->target_position_m, coordinates) +
                             line_of(solve->reached_position_m, reached) + data_number(solve->position_error_cm) + '\n';
    if (first.empty()) first = line;
    figure.data += line;
    largest_error =
        std::isfinite(solve->position_error_cm) ? std::max(largest_error, solve->position_error_cm) : not_defined;
  }
  const bool is_whole = static_cast<int>(solves.size()) == study.points;
  if (study.facts.path == "circle" && is_whole) figure.data += first;  // closes it
  figure.caption += std::isfinite(largest_error)
                        ? fmt::format(" The largest error is {} cm.", rounded_number(largest_error, 2))
                        : " Some of its answers are not finite.";
  std::vector<std::string> clauses, labels{"target", "reached"};
  const auto add = [&](std::string_view what) { clauses.push_back(fmt::format("'{}.dat' {}", name, what)); };
  if (!study.facts.draws_targets) {
    labels.emplace_back("path");
    add("index 0 using 1:2:3 with lines lw 0.7 lc rgb '#888888' title 'path'");
  }
  const std::size_t arms = view == View::from_above ? 0 : view == View::with_arm ? 1 : 3;
  std::size_t at = 0, drawn = 0;
  for (const auto& [point, solve] : solves) {
    if (arms == 0 || at++ % ((solves.size() + arms - 1) / arms) != 0) continue;
    const std::vector<Point> corners = arm_points(study.facts, solve->answer_rad);
    if (corners.empty()) continue;
    figure.data += fmt::format("\n\n# the arm at point {}, from the base to the tool: x, y, z [cm]\n", point);
    for (const Point& corner : corners) {
      figure.data += line_of({corner.begin(), corner.end()}, coordinates) + '\n';
    }
    ++drawn;
    labels.emplace_back(fmt::format("arm at point {}", point));
    add(fmt::format("index {} using 1:2:3 with linespoints lw 1.6 pt 7 ps 0.4 lc rgb word(colours, {}) title '{}'",
                    drawn, drawn + 1, labels.back()));
  }
  add("index 0 using 1:2:3 with points pt 7 ps 0.35 lc rgb '#000000' title 'target'");
  add("index 0 using 4:5:6 with points pt 6 ps 0.8 lw 0.8 lc rgb word(colours, 1) title 'reached'");
  if (!study.facts.draws_targets && drawn == 0) {  // an arm at the first target says as much
    labels.emplace_back("start");
    add("index 0 using 1:2:3 every ::0::0 with points pt 4 ps 1.5 lw 1.2 lc rgb '#000000' title 'start'");
  }
  figure.settings = space_axes(coordinates);
  if (view == View::from_above) {
    figure.settings +=
        "set view noequal\nset view map\nset size ratio -1\nset border 3\nset xlabel offset 0, 0\n"
        "set ylabel offset -0.5, 0\n";
  }
  add_legend(figure, labels);
  figure.settings += fmt::format("set key at screen 0.5, 0.99 top center horizontal maxrows {}\n",
                                 (labels.size() + 1) / 2);  // below, gnuplot cuts it
  figure.plot = plot_command(clauses, "splot");
  return figure;
}

namespace {

// A metric of every solver, point by point over the runs.
struct Curves {
  std::vector<std::vector<double>> averages;  // of a solver, by point
  bool has_bands = false;
  std::map<int, std::vector<double>> by_point = {};  // the averages of all solvers, then the quartiles of each
  std::vector<double> all = {};

  // The column of gnuplot's data file, which begins with the point.
  static std::size_t column(std::size_t solver) { return solver + 2; }
  std::size_t band_column(std::size_t solver) const { return averages.size() + 2 + 2 * solver; }
};

Curves curves_of(const StudyResults& study, Metric metric) {
  Curves curves{.averages = {}, .has_bands = study.runs > 1 && study.solvers.size() <= most_bands};
  for (const std::string& solver : study.solvers) {
    curves.averages.push_back(averages_by_point(study, solver, metric));
    for (int point = 1; point <= study.points; ++point) {
      curves.by_point[point].push_back(curves.averages.back()[static_cast<std::size_t>(point) - 1]);
    }
  }
  for (const std::string& solver : study.solvers) {
    if (!curves.has_bands) break;
    std::map<int, std::vector<double>> values;
    for (const Solve& solve : solves_of(study, solver)) values[solve.point].push_back(value_of(study, solve, metric));
    for (int point = 1; point <= study.points; ++point) {
      const std::vector<double> ranked = ranked_values(values[point]);
      for (const double p : {0.25, 0.75}) {
        curves.by_point[point].push_back(quantile(ranked, p, quantile_type(study.plan.quartiles)));
      }
    }
  }
  for (const auto& [point, values] : curves.by_point) curves.all.insert(curves.all.end(), values.begin(), values.end());
  return curves;
}

}  // namespace

Figure curves_figure(const StudyResults& study, Metric metric, const std::string& name,
                     const std::map<int, std::vector<double>>& printed) {
  Figure figure{.name = name};
  Curves curves = curves_of(study, metric);
  const bool is_path = !study.facts.draws_targets, has_bands = curves.has_bands && is_path;
  std::vector<std::string> clauses{"NaN notitle"}, labels;
  if (!printed.empty()) {
    for (const auto& [point, values] : printed) curves.all.insert(curves.all.end(), values.begin(), values.end());
    labels.emplace_back("as printed");
    const std::string source = fmt::format("'{}.dat' index 1 using 1:(shown($2))", figure.name);
    clauses.push_back(source + " with lines lw 0.7 dt 2 lc rgb '#808080' notitle");
    clauses.push_back(fmt::format("{} with points dt 1 {} title '{}'", source, grey_rings, labels.back()));
  }
  labels.insert(labels.end(), study.solvers.begin(), study.solvers.end());
  const Axis axis =
      value_axis(curves.all, with_unit(metric),
                 metric == Metric::position_error_cm ? Scale::logarithmic : Scale::by_spread, info_of(metric).rounding);
  figure.caption = with_notes(
      fmt::format("{}: {} over the runs at each point.{}{}", capitalised(axis.quantity), average_name(metric),
                  has_bands ? " Bands: the middle half of the runs." : "", printed.empty() ? "" : " Grey: as printed."),
      study, metric, axis);
  figure.settings = axis.settings + point_axis(study.points);
  add_legend(figure, labels);

  const int points_per_marker = 1 + study.points / 40;
  const std::string_view with = is_path ? "linespoints" : "points";  // drawn targets have no order
  figure.data =
      fmt::format("# column 1: point; then {}, {} over the runs, of\n", quantity(metric), average_name(metric));
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    const std::size_t column = Curves::column(i), band = curves.band_column(i),
                      style = place_of(study, study.solvers[i]) + 1;
    figure.data += fmt::format("# column {}: {}{}\n", column, one_line(study.solvers[i]),
                               curves.has_bands ? fmt::format("; quartiles in {} and {}", band, band + 1) : "");
    if (has_bands) {
      clauses.push_back(
          fmt::format("'{}.dat' index 0 using 1:(shown(${})):(shown(${})) with filledcurves ls {} fillstyle "
                      "transparent solid 0.13 noborder notitle",
                      figure.name, band, band + 1, style));
    }
    const std::string label = shortened(study.solvers[i], longest_label);
    HoverTexts& texts = figure.hover_texts.emplace_back(HoverTexts{.series = label});
    for (std::size_t point = 0; point < curves.averages[i].size(); ++point) {
      const double average = curves.averages[i][point];
      if (!std::isfinite(average)) continue;
      texts.words.push_back(fmt::format("point {}: {}", point + 1, value_words(metric, average)));
    }
    if (std::ranges::any_of(curves.averages[i], [](double value) { return std::isfinite(value); })) {
      lines.push_back(fmt::format("'{}.dat' index 0 using 1:(shown(${})) with {} ls {} pointinterval {} title {}",
                                  figure.name, column, with, style, points_per_marker, gnuplot_string(label)));
    } else {  // in the legend all the same
      lines.push_back(
          fmt::format("keyentry with {} ls {} title {}", with, style, gnuplot_string(label + " (nothing to show)")));
    }
  }
  clauses.insert(clauses.end(), lines.begin(), lines.end());
  figure.data += lines_by_point(curves.by_point);
  if (!printed.empty()) figure.data += "\n\n# as printed: point, value\n" + lines_by_point(printed);
  figure.plot = plot_command(clauses);
  return figure;
}

namespace {

constexpr std::size_t most_panels = 12;

// The joints in a solver's first run: angles [deg], or positions [cm] if they slide.
struct Panel {
  std::string solver;
  int run;
  std::map<int, std::vector<double>> joints;
};

std::vector<Panel> panels_of(const StudyResults& study) {
  std::vector<Panel> panels;
  for (const std::string& solver : study.solvers) {
    const auto solves = first_run(study, solver);
    if (solves.empty()) continue;
    panels.push_back({solver, solves.begin()->second->run, joint_angles_deg(solves)});
    for (auto& [point, joints] : panels.back().joints) {
      for (const std::size_t joint : study.facts.slides) {
        if (joint < joints.size()) joints[joint] *= degree / centimetre;
      }
    }
    if (panels.back().joints.begin()->second.empty()) panels.pop_back();
  }
  return panels;
}

std::string panel_commands(const Panel& panel, const std::string& source, std::size_t place, const StudyFacts& facts) {
  const std::size_t joints = panel.joints.begin()->second.size();
  std::vector<std::string> clauses;
  for (std::size_t joint = 1; joint <= joints; ++joint) {
    clauses.push_back(fmt::format("{} index {} using 1:(${}) with {} ls {} ps 0.3 title 'joint {}{}'", source, place,
                                  joint + 1, facts.draws_targets ? "points" : "linespoints", joint, joint,
                                  facts.slides.contains(joint - 1) ? " [cm]" : ""));
  }
  return fmt::format("set title {} noenhanced offset 0, -0.7\n{}\nunset key\n",
                     gnuplot_string(shortened(panel.solver, 2 * longest_label)), plot_command(clauses));
}

}  // namespace

std::vector<JointLimits> limits_deg(const StudyFacts& facts, std::size_t joints) {
  std::vector<JointLimits> limits;
  const std::optional<Robot> arm = stored_arm(facts.json);
  if (!arm || arm->chain.links().size() != joints) return limits;
  for (std::size_t joint = 0; joint < joints; ++joint) {
    const auto j = static_cast<Eigen::Index>(joint);
    const double lower = arm->limits.lower[j], upper = arm->limits.upper[j];
    if (arm->chain.links()[joint].joint == Joint::slides || is_endless(lower, upper)) continue;
    limits.push_back({joint + 1, lower / degree, upper / degree});
  }
  return limits;
}

std::optional<Figure> joints_figure(const StudyResults& study, const std::string& name) {
  std::vector<Panel> panels = panels_of(study);
  if (panels.empty()) return std::nullopt;
  const std::size_t all = panels.size(), joints = panels.front().joints.begin()->second.size();
  panels.resize(std::min(all, most_panels), panels.front());
  const std::size_t columns = std::min<std::size_t>(panels.size(), 3), rows = (panels.size() + columns - 1) / columns;
  const std::size_t legend_rows = 1 + (joints - 1) / (study.facts.slides.empty() ? 8 : 6);
  const double more_legend = 0.45 * static_cast<double>(legend_rows - 1);  // [cm]
  Figure figure{.name = name,
                .caption = fmt::format("Joint angles{} {}, in the first run of each solver.",
                                       study.facts.slides.empty() ? "" : " [deg] and positions of slides [cm]",
                                       !study.facts.draws_targets ? "along the path" : "at each target"),
                .width_cm = two_columns_cm,
                .height_cm = 1.6 + more_legend + 4.2 * static_cast<double>(rows)};
  double range = 180;
  for (const Panel& panel : panels) {
    figure.data += fmt::format(
        "{}# {}, run {}: point, then the angle of each joint [deg], or its position [cm] where it slides\n{}",
        figure.data.empty() ? "" : "\n\n", one_line(panel.solver), panel.run, lines_by_point(panel.joints));
    for (const auto& [point, values] : panel.joints) {
      for (const double angle : values) range = std::isfinite(angle) ? std::max(range, std::abs(angle)) : range;
    }
  }
  figure.settings = point_axis(study.points) + fmt::format(
                                                   "set yrange [{0}:{1}]\n{2}set key at screen 0.5, 0.01 "
                                                   "bottom center vertical maxrows {3}\n",
                                                   -range, range, range <= 180 ? "set ytics 60\n" : "", legend_rows);
  std::map<std::pair<double, double>, std::vector<std::size_t>> pairs;  // each once, with the joints that have it
  for (const auto& [joint, lower, upper] : limits_deg(study.facts, joints)) pairs[{lower, upper}].push_back(joint);
  std::vector<std::string> limits;
  for (const auto& [pair, of_joints] : pairs) {
    limits.push_back(fmt::format("{} to {} deg (joint{} {})", rounded_number(pair.first, 4),
                                 rounded_number(pair.second, 4), of_joints.size() == 1 ? "" : "s",
                                 fmt::join(of_joints, ", ")));
    for (const double limit : {pair.first, pair.second}) {
      figure.settings += fmt::format(
          "set arrow from graph 0, first {0} to graph 1, first {0} nohead back lw 0.6 dt 2 lc rgb '#777777'\n",
          text_of(limit));
    }
  }
  if (!limits.empty()) figure.caption += fmt::format(" Dashed: the joint limits, {}.", fmt::join(limits, "; "));
  if (panels.size() < all)
    figure.caption += fmt::format(" Only the first {} of {} solvers are shown.", most_panels, all);
  const double bottom = (1.9 + more_legend) / figure.height_cm, top = 1 - 0.6 / figure.height_cm,
               gap = 1.2 / figure.height_cm;
  figure.plot =
      fmt::format("set multiplot layout {}, {} rowsfirst margins 0.1, 0.99, {}, {} spacing 0.03, {}\nset key\n", rows,
                  columns, text_of(bottom), text_of(top), text_of(gap));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const bool is_inner = i % columns > 0;  // the first of its row has the axis of all
    figure.plot +=
        fmt::format("set xlabel '{}'\nset ylabel '{}'\nset format y '{}'\n", i + columns < panels.size() ? "" : "point",
                    is_inner ? "" : "joint angle [deg]", is_inner ? "" : "%g");
    figure.plot += panel_commands(panels[i], fmt::format("'{}.dat'", name), i, study.facts);
  }
  figure.plot += "unset multiplot";
  return figure;
}

}  // namespace ikbench::figures
