#include "analysis/slim2023/paper_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/definition.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/circle_figures.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

constexpr double two_columns_cm = 17.0;

// 0 is a, 25 z, 26 aa.
std::string letters(std::size_t index) {
  std::string text(1, static_cast<char>('a' + index % 26));
  return index < 26 ? text : letters(index / 26 - 1) + text;
}

}  // namespace

Figure path_figure(const StudyResults& study) {
  const std::string solver = study.solves.front().solver;
  const bool is_path = !Definition(study.definition).draws_targets();
  Figure figure{.name = "figure-5",
                .caption = fmt::format("The targets ({}dots) and where {} came to in its first run (rings).",
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
                        ? fmt::format(" The farthest is {} cm off.", rounded_number(largest_error, 2))
                        : " Not all of its answers are finite.";
  figure.settings = space_axes(coordinates) + "unset key\n";
  std::vector<std::string> clauses;
  if (is_path) clauses.emplace_back("'figure-5.dat' using 1:2:3 with lines lw 0.7 lc rgb '#888888'");
  clauses.emplace_back("'figure-5.dat' using 1:2:3 with points pt 7 ps 0.35 lc rgb '#000000'");
  clauses.emplace_back("'figure-5.dat' using 4:5:6 with points pt 6 ps 0.8 lw 0.8 lc rgb '#0072B2'");
  if (is_path) {
    clauses.emplace_back("'figure-5.dat' using 1:2:3:('start') every ::0::0 with labels right offset -0.9,0.4");
  }
  figure.plot = plot_command(clauses, "splot");
  return figure;
}

Figure curves_figure(const StudyResults& study, Metric metric) {
  Figure figure{.name = fmt::format("figure-{}", paper_numbers(metric).curves_figure),
                .caption = fmt::format("{}: mean over the runs at each point.", capitalised(quantity(metric)))};
  std::vector<std::vector<double>> curves;
  std::vector<double> all;
  for (const std::string& solver : study.solvers) {
    curves.push_back(means_by_point(study, solver, metric));
    all.insert(all.end(), curves.back().begin(), curves.back().end());
  }
  const Axis axis =
      value_axis(all, quantity(metric), metric == Metric::position_error_cm ? Scale::logarithmic : Scale::by_spread);
  figure.caption = with_notes(figure.caption, study, metric, axis);
  figure.settings = axis.settings + point_axis(study.points);
  add_legend(figure, study.solvers);

  const int points_per_marker = 1 + study.points / 40;
  figure.data = fmt::format("# column 1: point; then {}, mean over the runs, of\n", quantity(metric));
  std::vector<std::string> clauses{"NaN notitle"};
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    figure.data += fmt::format("# column {}: {}\n", i + 2, one_line(study.solvers[i]));
    const std::string label = shortened(study.solvers[i], longest_label);
    if (std::ranges::any_of(curves[i], [](double value) { return std::isfinite(value); })) {
      clauses.push_back(fmt::format("'{}.dat' using 1:(shown(${})) with linespoints ls {} pointinterval {} title {}",
                                    figure.name, i + 2, i + 1, points_per_marker, gnuplot_string(label)));
    } else {  // in the legend all the same
      clauses.push_back(
          fmt::format("keyentry with linespoints ls {} title {}", i + 1, gnuplot_string(label + " (nothing to show)")));
    }
  }
  for (std::size_t point = 0; point < static_cast<std::size_t>(study.points); ++point) {
    figure.data += fmt::to_string(point + 1);
    for (const auto& curve : curves) figure.data += ' ' + data_number(curve[point]);
    figure.data += '\n';
  }
  figure.plot = plot_command(clauses);
  return figure;
}

std::vector<Figure> joint_figures(const StudyResults& study) {
  std::vector<Figure> figures;
  for (const std::string& solver : study.solvers) {
    const auto solves = first_run(study, solver);
    if (solves.empty()) continue;
    Figure figure{
        .name = "figure-9-" + letters(figures.size()),
        .caption = fmt::format("Joint angles along the path, run {} of {}.", solves.begin()->second->run, solver)};
    std::size_t joints = 0;
    double largest = 180;
    for (const auto& [point, solve] : solves) {
      joints = std::max(joints, solve->answer_rad.size());
      for (const double angle : solve->answer_rad) {
        if (std::isfinite(angle)) largest = std::max(largest, std::abs(angle) * 180 / std::numbers::pi);
      }
    }
    figure.data = "# point, then the angle of each joint [deg]\n";
    for (const auto& [point, solve] : solves) {
      figure.data += fmt::to_string(point);
      for (std::size_t joint = 0; joint < joints; ++joint) {
        const double angle = joint < solve->answer_rad.size() ? solve->answer_rad[joint] : not_defined;
        figure.data += ' ' + data_number(angle * 180 / std::numbers::pi);
      }
      figure.data += '\n';
    }
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

Figure box_figure(const StudyResults& study, const BoxRequest& request) {
  const std::string observation = request.unit == Unit::run ? "run means" : "points";
  Figure figure{
      .name = fmt::format("figure-{}", paper_numbers(request.metric).box_figure),
      .caption = fmt::format("{}: box plots over the {}. Quartiles of type {} (Hyndman and Fan), whiskers to the "
                             "last value within 1.5 box heights.",
                             capitalised(quantity(request.metric)), observation, static_cast<int>(request.quartiles))};
  std::vector<Box> boxes;
  std::vector<double> all;
  for (const Sample& sample : samples(study, request.metric, request.unit)) {
    boxes.push_back(box(sample.values, request.quartiles));
    all.insert(all.end(), sample.values.begin(), sample.values.end());
  }
  // What the paper prints of the same solver, but for times: those are of another machine.
  std::string printed_marks;
  if (request.unit == Unit::run && request.metric != Metric::seconds) {
    for (std::size_t i = 0; i < study.solvers.size(); ++i) {
      const auto printed = printed_row(study, study.solvers[i], request.metric);
      if (!printed) continue;
      printed_marks += fmt::format("{} {} {} {}\n", i + 1, data_number(printed->min), data_number(printed->median),
                                   data_number(printed->max));
      all.insert(all.end(), {printed->min, printed->median, printed->max});
    }
  }
  if (!printed_marks.empty()) figure.caption += " Grey: smallest, median and largest value as printed.";
  const Axis axis = value_axis(all, quantity(request.metric), Scale::by_spread);
  figure.caption = with_notes(figure.caption, study, request.metric, axis);

  const std::size_t n = boxes.size();
  if (n > 8) figure.width_cm = two_columns_cm;
  std::size_t longest = 0;
  std::string ticks;
  std::string counts;
  std::string outliers;
  figure.data =
      "# solver's position, lower whisker, q1, median, q3, upper whisker, observations, of those not finite\n";
  for (std::size_t i = 0; i < n; ++i) {
    const Box& b = boxes[i];
    const std::string label = shortened(study.solvers[i], longest_label);
    longest = std::max(longest, character_count(label));
    ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", tick_label(label), i + 1);
    figure.data += fmt::format("# {}\n{} {} {} {} {} {} {} {}\n", one_line(study.solvers[i]), i + 1,
                               data_number(b.whisker_low), data_number(b.q1), data_number(b.median), data_number(b.q3),
                               data_number(b.whisker_high), b.n, b.not_finite);
    for (const double value : b.outliers) outliers += fmt::format("{} {}\n", i + 1, data_number(value));
    if (b.not_finite > 0 || b.n == 0) {
      const std::string words = b.n == 0 ? "nothing" : fmt::format("{} not", b.not_finite);
      counts += fmt::format("set label \"{}\\n{}\" at {}, graph 1 center offset 0, 1.1 font ',6'\n", words,
                            b.n == 0 ? "solved" : "finite", i + 1);
    }
  }
  if (outliers.empty()) outliers = "1 NaN\n";
  figure.data += fmt::format("\n\n# outliers: solver's position, value\n{}", outliers);
  if (!printed_marks.empty()) {
    figure.data += "\n\n# as printed: solver's position, smallest, median, largest\n" + printed_marks;
  }

  if (!counts.empty()) counts += "set tmargin 2.5\n";

  // Labels lie flat where they have room (about 6 characters a centimetre), else they stand.
  const double room = (figure.width_cm - 1.8) / static_cast<double>(n) * 6;
  const bool standing = static_cast<double>(longest) > room;
  if (standing) {
    const double label_cm = 0.13 * static_cast<double>(longest) + 0.4;
    figure.height_cm += label_cm;
    counts += fmt::format("set bmargin at screen {}\n", text_of(label_cm / figure.height_cm));
  }
  figure.settings = axis.settings + counts +
                    fmt::format(
                        "unset key\nset grid noxtics ytics\nset xrange [0.4:{}.6]\nset xtics font ',7' {}({})\n"
                        "set boxwidth 0.5\nset style fill solid 0.25 border\n",
                        n, standing ? "rotate by 90 right " : "", ticks);
  std::vector<std::string> clauses;
  for (std::size_t i = 0; i < n; ++i) {
    if (!boxes[i].drawable()) continue;
    clauses.push_back(
        fmt::format("'{}.dat' index 0 every ::{}::{} using 1:(shown($3)):(shown($2)):(shown($6)):(shown($5)) with "
                    "candlesticks ls {} "
                    "dt 1 whiskerbars 0.5",
                    figure.name, i, i, i + 1));
  }
  clauses.push_back(
      fmt::format("'{}.dat' index 0 using ($1-0.25):(shown($4)):(0.5):(0) with vectors nohead ls 101", figure.name));
  clauses.push_back(
      fmt::format("'{}.dat' index 1 using 1:(shown($2)) with points pt 6 ps 0.4 lw 0.8 lc rgb '#000000'", figure.name));
  if (!printed_marks.empty()) {
    clauses.push_back(fmt::format(
        "'{0}.dat' index 2 using ($1+0.36):(shown($2)):(0):(shown($4)-shown($2)) with vectors nohead lw 1.6 lc rgb "
        "'#AAAAAA', '' index 2 using ($1+0.29):(shown($3)):(0.14):(0) with vectors nohead lw 1.6 lc rgb '#777777'",
        figure.name));
  }
  figure.plot = plot_command(clauses);
  return figure;
}

std::vector<Figure> paper_figures(const StudyResults& study, Unit unit, QuantileType quartiles) {
  if (study.solves.empty()) return {};
  std::vector<Figure> figures{path_figure(study)};
  for (const Metric metric : paper_metrics) figures.push_back(curves_figure(study, metric));
  for (Figure& figure : joint_figures(study)) figures.push_back(std::move(figure));
  for (const Metric metric : paper_metrics) {
    figures.push_back(box_figure(study, {.metric = metric, .unit = unit, .quartiles = quartiles}));
  }
  for (Figure& figure : circle_figures(study)) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace ikbench::slim2023
