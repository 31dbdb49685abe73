#include "analysis/figures/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "analysis/figures/arm.hpp"
#include "analysis/figures/figure_parts.hpp"
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

Figure path_figure(const StudyResults& all, const std::string& name, View view) {
  const StudyResults study = drawn_part(all);
  const std::string solver = solver_of(study, study.solves.front());
  const bool is_path = !study.facts.draws_targets;
  Figure figure{.name = name,
                .caption = fmt::format("Targets, and positions that {} reached in its first run.", solver),
                .height_cm = 8.0};
  figure.data = "# target x, y, z [cm]; reached x, y, z [cm] and position error [cm] of " + one_line(solver) + "\n";
  std::array<std::vector<double>, 3> shown_cm;  // by the axes, which what was reached does not widen
  const auto add_point = [&](std::span<const double> position_m, bool is_shown) {
    for (std::size_t axis = 0; axis < shown_cm.size(); ++axis) {
      const double cm = position_m.size() == shown_cm.size() ? 100 * position_m[axis] : not_defined;
      if (std::isfinite(cm) && is_shown) shown_cm[axis].push_back(cm);
      figure.data += data_number(cm) + ' ';
    }
  };
  double largest_error = 0;
  const auto solves = first_run(study, solver);
  const std::size_t begin = figure.data.size();
  for (const auto& [point, solve] : solves) {
    add_point(solve->target_position_m, true);
    add_point(solve->reached_position_m, false);
    figure.data += data_number(solve->position_error_cm) + '\n';
    largest_error =
        std::isfinite(solve->position_error_cm) ? std::max(largest_error, solve->position_error_cm) : not_defined;
  }
  const bool is_whole = static_cast<int>(solves.size()) == study.points;
  if (study.facts.path == "circle" && is_whole) {  // closes it
    figure.data += figure.data.substr(begin, figure.data.find('\n', begin) + 1 - begin);
  }
  figure.caption += std::isfinite(largest_error)
                        ? fmt::format(" The largest error is {} cm.", rounded_number(largest_error, 2))
                        : " Some of its answers are not finite.";
  std::vector<std::string> clauses, labels;
  const auto add = [&](std::string label, std::string_view what) {
    clauses.push_back(fmt::format("data index {} title '{}'", what, label));
    labels.push_back(std::move(label));
  };
  if (is_path) add("path", "0 using 1:2:3 with lines lw 0.7 lc rgb '#888888'");
  const std::size_t arms = view == View::from_above ? 0 : view == View::with_arm ? 1 : 3;
  std::size_t at = 0, drawn = 0;
  for (const auto& [point, solve] : solves) {
    if (arms == 0 || at++ % ((solves.size() + arms - 1) / arms) != 0) continue;
    const std::vector<Point> corners = arm_points(study.facts, solve->answer_rad);
    if (corners.empty()) continue;
    figure.data += fmt::format("\n\n# the arm at point {}, from the base to the tool: x, y, z [cm]\n", point);
    for (const Point& corner : corners) {
      add_point(corner, true);
      figure.data += '\n';
    }
    ++drawn;
    add(fmt::format("arm at point {}", point),
        fmt::format("{} using 1:2:3 with linespoints lw 1.6 pt 7 ps 0.4 lc rgb word(colours, {})", drawn, drawn + 1));
  }
  add("target", "0 using 1:2:3 with points pt 7 ps 0.35 lc rgb '#000000'");
  add("reached", "0 using 4:5:6 with points pt 6 ps 0.8 lw 0.8 lc rgb word(colours, 1)");
  if (is_path && drawn == 0) {  // an arm at the first target says as much
    add("start", "0 every ::0::0 using 1:2:3 with points pt 4 ps 1.5 lw 1.2 lc rgb '#000000'");
  }
  figure.settings = space_axes(shown_cm);
  if (view == View::from_above) {
    figure.settings +=
        "set view noequal\nset view map\nset size ratio -1\nset border 3\nset xlabel offset 0, 0\n"
        "set ylabel offset 0.3, 0\n";
  }
  add_legend(figure, labels);
  figure.settings += fmt::format("set key at screen 0.5, 0.99 top center horizontal maxrows {}\n",
                                 (labels.size() + 1) / 2);  // below, gnuplot cuts it
  figure.plot = plot_command(clauses, "splot");
  return figure;
}

Figure curves_figure(const StudyResults& measured, Metric metric, const std::string& name,
                     const std::map<int, std::vector<double>>& printed, Curves shown) {
  const StudyResults study = drawn_part(measured);
  const bool is_path = !study.facts.draws_targets;
  const bool has_means = shown == Curves::means && study.runs > 1;
  const bool has_bands = is_path && study.runs > 1 && study.solvers.size() <= most_bands && !has_means;
  Figure figure{.name = name};
  std::vector<Curve> curves;
  std::vector<double> all;
  for (const std::string& solver : study.solvers) {
    Curve curve;
    if (has_bands) curve.band = 0;
    bool has_any = false;
    for (const std::vector<double>& values : values_by_point(study, solver, metric)) {
      const std::vector<double> ranked = ranked_values(values);
      const auto quartile = [&](double p) { return quantile(ranked, p, QuantileType{study.plan.quartiles}); };
      const Estimate average = has_means ? Estimate{mean(values), quartile(0.5), quartile(0.5)}
                                         : Estimate{quartile(0.5), quartile(0.25), quartile(0.75)};
      curve.add(static_cast<double>(curve.count + 1), average);
      all.push_back(average.value);
      if (has_bands || has_means) all.insert(all.end(), {average.low, average.high});
      has_any = has_any || std::isfinite(average.value);
    }
    curves.push_back(has_any ? curve : Curve());
  }
  std::vector<std::string> clauses;
  for (std::size_t i = 0; has_means && i < curves.size(); ++i) {
    clauses.push_back(fmt::format("data index {} using (shown_x($1)):(shown($3)) with lines ls {} lw 0.5 dt 3", i,
                                  style_of(study, study.solvers[i])));
  }
  if (!printed.empty()) {
    for (const auto& [point, values] : printed) all.insert(all.end(), values.begin(), values.end());
    const std::string source = fmt::format("data index {} using 1:(shown($2)) with", curves.size());
    clauses.push_back(source + " lines lw 0.7 dt 2 lc rgb '#808080'");
    clauses.push_back(fmt::format("{} points dt 1 {} title 'as printed'", source, grey_rings));
  }
  const Axis axis =
      value_axis(all, with_unit(metric), metric == Metric::position_error_cm ? Scale::logarithmic : Scale::by_spread,
                 info_of(metric).rounding);
  figure.caption = with_notes(fmt::format("{}: {} at each point.{}{}", capitalised(axis.quantity),
                                          has_means        ? "average over the runs"
                                          : study.runs > 1 ? "median over the runs"
                                                           : "that of the run",
                                          has_means   ? " Dotted: the median."
                                          : has_bands ? " Bands: the middle half of the runs."
                                                      : "",
                                          printed.empty() ? "" : " Grey: as printed."),
                              study, metric, axis);
  figure.settings = axis.settings + point_axis(study.points);
  figure.data = fmt::format(
      "# point; {}: {}\n", quantity(metric),
      has_means ? "average over the runs, and their median, twice" : "median over the runs, and their quartiles");
  std::vector<std::string> labels = add_curves(figure, study, curves, clauses, is_path ? "linespoints" : "points");
  if (!printed.empty()) {
    labels.emplace_back("as printed");
    figure.data += "\n\n# as printed: point, value\n" + lines_by_point(printed);
  }
  add_legend(figure, labels);
  return figure;
}

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

// For each joint, a later one whose curve hides its own in every panel; 0 if there is none. Both from 1. `rows`: the
// values of all joints at each point of each panel.
std::vector<std::size_t> hiding_joints(const std::vector<std::vector<double>>& rows, std::size_t joints) {
  constexpr double hidden = 1;  // of the axis' degrees
  std::vector<std::size_t> later(joints);
  for (std::size_t joint = 0; joint < joints; ++joint) {
    for (std::size_t other = joint + 1; other < joints && later[joint] == 0; ++other) {
      const bool is_same = std::ranges::all_of(rows, [&](const std::vector<double>& row) {
        return std::max(joint, other) < row.size() && std::abs(row[joint] - row[other]) <= hidden;
      });
      if (is_same) later[joint] = other + 1;
    }
  }
  return later;
}

// A panel for each solver: angles [deg], or positions [cm] of joints that slide.
std::optional<Figure> joints_figure(const StudyResults& all, const std::string& name,
                                    std::optional<std::size_t> repeated) {
  const StudyResults study = drawn_part(all);
  constexpr std::size_t most_panels = 12;
  const bool has_slides = !study.facts.slides.empty();
  Figure figure{.name = name, .width_cm = two_columns_cm};
  std::vector<std::string> solvers;
  std::size_t joints = 0;
  double range = 180;
  std::vector<std::vector<double>> drawn;
  for (const std::string& solver : study.solvers) {
    const auto solves = first_run(study, solver);
    auto angles = joint_angles_deg(solves);
    if (angles.empty() || angles.begin()->second.empty()) continue;
    for (auto& [point, values] : angles) {
      if (repeated && *repeated <= values.size()) values.push_back(values[*repeated - 1]);
    }
    solvers.push_back(solver);
    joints = std::max(joints, angles.begin()->second.size());
    if (solvers.size() > most_panels) continue;
    for (auto& [point, values] : angles) {
      for (std::size_t joint = 0; joint < values.size(); ++joint) {
        if (study.facts.slides.contains(joint)) values[joint] *= degree / centimetre;
        if (std::isfinite(values[joint])) range = std::max(range, std::abs(values[joint]));
      }
      drawn.push_back(values);
    }
    figure.data += fmt::format(
        "{}# {}, run {}: point, then the angle of each joint [deg], or its position [cm] where it slides\n{}",
        figure.data.empty() ? "" : "\n\n", one_line(solver), solves.begin()->second->run, lines_by_point(angles));
  }
  if (solvers.empty()) return std::nullopt;
  figure.caption = fmt::format("Joint angles{} {}, in the first run of each solver.",
                               has_slides ? " [deg] and positions of slides [cm]" : "",
                               study.facts.draws_targets ? "at each target" : "along the path");
  const std::size_t panels = std::min(solvers.size(), most_panels), columns = std::min<std::size_t>(panels, 3),
                    rows = (panels + columns - 1) / columns;
  figure.height_cm = 0.94 + 4.2 * static_cast<double>(rows);
  figure.legend = joints;
  figure.legend_cm = has_slides ? 2.6 : 1.95;
  figure.settings =
      point_axis(study.points) + fmt::format(
                                     "if (width_cm < {0} * text / 8) set xtics {1}\nset yrange [{2}:{3}]\n{4}"
                                     "set key at screen 0.5, 0.01 bottom center vertical maxrows legend_rows\n",
                                     text_of(2.0 + 4.0 * static_cast<double>(columns)),
                                     study.points <= 2 ? 1 : round_step(study.points, 2), -range, range,
                                     range <= 180 ? "set ytics 60\n" : "");
  std::map<std::pair<double, double>, std::vector<std::size_t>> pairs;  // each once, with the joints that have it
  std::vector<std::string> limits, rings;
  for (const auto& [joint, lower, upper] : limits_deg(study.facts, joints)) {
    pairs[{lower, upper}].push_back(joint);
    constexpr double rounding = 1e-6;  // of an angle that is at its limit
    const double least = lower - rounding, most = upper + rounding;
    const bool leaves = std::ranges::any_of(drawn, [&](const std::vector<double>& row) {
      return joint <= row.size() && (row[joint - 1] < least || row[joint - 1] > most);
    });
    if (!leaves) continue;
    rings.push_back(fmt::format(
        "data index panel using 1:(${0} < {1} || ${0} > {2} ? ${0} : NaN) with points ls {3} pt 6 ps 0.9 notitle",
        joint + 1, text_of(least), text_of(most), joint));
  }
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
  if (!rings.empty()) figure.caption += " Rings: angles outside them.";
  if (panels < solvers.size()) {
    figure.caption += fmt::format(" Only the first {} of {} solvers are shown.", panels, solvers.size());
  }
  const std::vector<std::size_t> later = hiding_joints(drawn, joints);
  std::vector<std::string> clauses;
  for (std::size_t joint = 1; joint <= joints; ++joint) {
    const bool is_hidden = later[joint - 1] > 0;
    clauses.push_back(fmt::format("data index panel using 1:(${}) with {} ls {} {} title 'joint {}{}'", joint + 1,
                                  study.facts.draws_targets ? "points" : "linespoints", joint,
                                  is_hidden ? "lw 3 ps 0.8" : "ps 0.3", joint,
                                  study.facts.slides.contains(joint - 1) ? " [cm]" : ""));
    if (is_hidden) figure.caption += fmt::format(" Joint {} (wide) moves as joint {} does.", joint, later[joint - 1]);
  }
  clauses.insert(clauses.end(), rings.begin(), rings.end());
  figure.plot = fmt::format(
      "set multiplot layout {}, {} rowsfirst margins margin(1.7), 1 - margin(0.2), up(1.54 + 0.36 * legend_rows), 1 - up(0.6) "
      "spacing margin(0.5), up(1.2)\nset key\n",
      rows, columns);
  for (std::size_t i = 0; i < panels; ++i) {
    const bool is_inner = i % columns > 0;  // the first of its row has the axis of all
    const std::string letter = panels > 1 ? fmt::format("({}) ", static_cast<char>('a' + i)) : "";
    figure.plot += fmt::format(
        "panel = {}\nset xlabel '{}'\nset ylabel '{}'\nset format y '{}'\nset title {} noenhanced offset 0, -0.7\n{}\n"
        "unset key\n",
        i, i + columns < panels ? "" : "point", is_inner ? "" : "joint angle [deg]", is_inner ? "" : "%g",
        gnuplot_string(letter + shortened(solvers[i], 2 * longest_label)), plot_command(clauses));
  }
  figure.plot += "unset multiplot";
  return figure;
}

}  // namespace ikbench::figures
