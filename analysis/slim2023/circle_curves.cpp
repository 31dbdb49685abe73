#include "analysis/slim2023/circle_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "analysis/claims/rules_of_solves.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"
#include "robots/robot.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

// Best error after every iteration, mean over the solves; a solve that ended earlier keeps its last.
std::vector<double> mean_trace(const StudyResults& study, const std::string& solver) {
  std::vector<const std::vector<double>*> traces;
  std::size_t iterations = 0;
  for (const Solve& solve : solves_of(study, solver)) {
    if (trace_cm(solve).empty()) continue;
    traces.push_back(&trace_cm(solve));
    iterations = std::max(iterations, trace_cm(solve).size());
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

// The limits of each joint [deg].
struct Limits {
  std::vector<double> lower, upper;
};

// Draws the limits within the axis, dashed.
std::string limits_settings(const Limits& limits, double low, double high) {
  std::string settings;
  for (std::size_t joint = 0; joint < limits.lower.size(); ++joint) {
    for (const double limit : {limits.lower[joint], limits.upper[joint]}) {
      if (!(limit > low && limit < high)) continue;
      settings += fmt::format(
          "set arrow from graph 0, first {0} to graph 1, first {0} nohead lw 0.7 dt 2 lc rgb word(colours, {1})\n",
          text_of(limit), joint % 7 + 1);
    }
  }
  return settings;
}

std::string limits_words(const Limits& limits) {
  std::vector<std::string> words;
  for (std::size_t joint = 0; joint < limits.lower.size(); ++joint) {
    words.push_back(
        fmt::format("{} to {} deg", rounded_number(limits.lower[joint], 4), rounded_number(limits.upper[joint], 4)));
  }
  return words.empty() ? ""
                       : fmt::format(" Dashed: joint limits within the axis; those of joints 1 to {} are {}.",
                                     words.size(), fmt::join(words, ", "));
}

}  // namespace

Figure circle_joints_figure(const StudyResults& study) {
  const std::string& solver = solver_of(study, study.solves.front());
  const auto solves = first_run(study, solver);
  std::vector<double> lower, upper;  // [deg]
  if (const auto arm = robots::stored_arm(study.facts.json)) {
    for (Eigen::Index j = 0; j < arm->joints() && !robots::is_endless(arm->limits.lower[j], arm->limits.upper[j]);
         ++j) {
      lower.push_back(arm->limits.lower[j] * 180 / std::numbers::pi);
      upper.push_back(arm->limits.upper[j] * 180 / std::numbers::pi);
    }
  }
  const std::vector<PrintedPosture> printed = printed_table_8(study.facts.published);
  std::map<int, std::vector<double>> angles = joint_angles_deg(solves);
  const bool has_fourth = angles.begin()->second.size() == 3;  // as in the paper: turns the tool as joint 1 the arm
  for (auto& [point, of_joints] : angles) {
    if (has_fourth) of_joints.push_back(of_joints[0]);
  }
  const std::size_t joints = angles.begin()->second.size();

  Figure figure{.name = "figure-16", .caption = fmt::format("Joint angles along the circle, first run of {}.", solver)};
  if (has_fourth) figure.caption += " Joint 4 turns the tool by the angle of joint 1, as in the paper.";
  std::vector<double> all;
  figure.data = "# point, then the angle of each joint [deg]\n" + lines_by_point(angles);
  for (const auto& [point, of_joints] : angles) all.insert(all.end(), of_joints.begin(), of_joints.end());
  std::vector<std::string> clauses{"NaN notitle"}, labels;
  if (!printed.empty()) {
    figure.caption += " Grey: as printed.";
    figure.data += "\n\n# as printed: point, then the angle of each joint [deg]\n";
    for (const PrintedPosture& posture : printed) {
      figure.data += fmt::format("{} {}\n", posture.point, fmt::join(posture.angles_deg, " "));
      all.insert(all.end(), posture.angles_deg.begin(), posture.angles_deg.end());
    }
    for (int joint = 1; joint <= 4; ++joint) {
      clauses.push_back(fmt::format("'{}.dat' index 1 using 1:{} with points {} {}", figure.name, joint + 1, grey_rings,
                                    joint == 1 ? "title 'as printed'" : "notitle"));
    }
  }
  for (std::size_t joint = 1; joint <= joints; ++joint) {
    labels.push_back(fmt::format("joint {}", joint));
    const bool is_fourth = has_fourth && joint == joints;  // on the line of joint 1
    clauses.push_back(fmt::format("'{}.dat' index 0 using 1:{} with {} ls {}{} title '{}'", figure.name, joint + 1,
                                  is_fourth ? "points" : "linespoints", joint, is_fourth ? " pt 8 ps 0.8" : "",
                                  labels.back()));
  }
  std::erase_if(all, [](double angle) { return !std::isfinite(angle); });
  if (all.empty()) {
    figure.settings += "set yrange [-180:180]\nset label 'no finite values' at graph 0.5, graph 0.5 center\n";
  } else {
    const auto [smallest, largest] = std::ranges::minmax(all);
    const double margin = std::max(5.0, 0.05 * (largest - smallest));
    const double low = smallest - margin, high = largest + margin;
    figure.settings += fmt::format("set yrange [{}:{}]\n", text_of(low), text_of(high));
    figure.settings += limits_settings({lower, upper}, low, high);
    figure.caption += limits_words({lower, upper});
    if (largest - smallest <= 400) figure.settings += "set ytics 30\n";
  }
  figure.settings += "set ylabel 'joint angle [deg]'\n" + point_axis(study.points);
  labels.push_back("as printed");
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

Figure circle_errors_figure(const StudyResults& study) {
  std::map<int, std::vector<double>> printed;
  for (const PrintedPosture& posture : printed_table_8(study.facts.published))
    printed[posture.point] = {posture.error_cm};
  return curves_figure(study, Metric::position_error_cm, "figure-17", printed);
}

Figure convergence_figure(const StudyResults& study) {
  const double rounding_cm = claims::farthest_target_cm(study) * std::numeric_limits<double>::epsilon();
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
    for (std::size_t k = 0; k < curve.size(); ++k) figure.data += fmt::format("{} {}\n", k + 1, data_number(curve[k]));
    all.insert(all.end(), curve.begin(), curve.end());
    iterations = std::max(iterations, curve.size());
    labels.push_back(shortened(study.solvers[i], longest_label));
    clauses.push_back(fmt::format("'{}.dat' index {} using 1:(shown($2)) with lines ls {} lw 1.3 title {}", figure.name,
                                  clauses.size(), i + 1, gnuplot_string(labels.back())));
  }
  const Axis axis = value_axis(all, {"average position error", "cm"}, Scale::logarithmic);
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

}  // namespace ikbench::slim2023
