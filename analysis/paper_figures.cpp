#include "analysis/paper_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

#include "analysis/axis.hpp"
#include "analysis/descriptive.hpp"
#include "analysis/published_numbers.hpp"
#include "analysis/text.hpp"
#include "results/number.hpp"

namespace ikbench {
namespace {

constexpr std::size_t longest_label = 28;  // characters of a solver's label in a figure; the data file has all
constexpr double two_columns_cm = 17.0;

std::string_view quantity(Metric metric) {
  constexpr std::array<std::string_view, 4> names{"position error [cm]", "angles variation [deg]", "computing time [s]",
                                                  "evaluations"};
  return names[static_cast<std::size_t>(metric)];
}

std::string capitalised(std::string_view text) {
  std::string result(text);
  result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
  return result;
}

std::string number(double value) { return std::isfinite(value) ? text_of(value) : "NaN"; }

// Says what a reader of the picture must know.
std::string with_notes(std::string caption, const StudyResults& study, Metric metric, const Axis& axis) {
  if (axis.shows_at_edge) caption += " Values of zero are drawn at the lower edge.";
  if (metric == Metric::seconds) {
    if (const std::string note = timing_note(study); !note.empty()) caption += ' ' + note;
  }
  return caption;
}

// A tick's label is a format to gnuplot: %% is %.
std::string doubled_percent(std::string_view label) {
  std::string result;
  for (const char c : label) result.append(c == '%' ? 2 : 1, c);
  return result;
}

// The legend below the plot, in as many columns as fit, and the room that it takes.
void add_legend(Figure& figure, const std::vector<std::string>& labels) {
  std::size_t longest = 1;
  for (const std::string& label : labels) longest = std::max(longest, character_count(shortened(label, longest_label)));
  const double characters = figure.width_cm * 6.5;
  const auto columns =
      std::max<std::size_t>(1, static_cast<std::size_t>(characters / static_cast<double>(longest + 7)));
  const std::size_t rows = (labels.size() + columns - 1) / columns;
  figure.settings += fmt::format("set key maxcols {}\n", columns);
  figure.height_cm += 0.3 + 0.36 * static_cast<double>(rows);
}

// Ticks at whole points: 1 and multiples of a round step.
std::string point_axis(int points) {
  int step = 1;
  for (int decade = 1; points > 10 * step; decade *= 10) {
    for (const int round : {1, 2, 5}) {
      if (points > 5 * step) step = decade * round;
    }
  }
  return fmt::format("set xlabel 'point'\nset xrange [0.5:{}.5]\nset xtics {}\n{}", points, step,
                     step > 1 ? "set xtics add ('1' 1)\n" : "");
}

std::string plot_command(const std::vector<std::string>& clauses, std::string_view command = "plot") {
  return fmt::format("{} {}", command, fmt::join(clauses, ", \\\n  "));
}

// Mean over the runs at every point; a point with an answer that is not finite has none.
std::vector<double> means_by_point(const StudyResults& study, const std::string& solver, Metric metric) {
  std::vector<std::vector<double>> values(static_cast<std::size_t>(study.points));
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver == solver) values[static_cast<std::size_t>(solve.point) - 1].push_back(value_of(solve, metric));
  }
  std::vector<double> means;
  for (const auto& at_point : values) means.push_back(mean(at_point));
  return means;
}

// The first run that the solver has, by point.
std::map<int, const SolveRecord*> first_run(const StudyResults& study, const std::string& solver) {
  int run = 0;
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver == solver && (run == 0 || solve.run < run)) run = solve.run;
  }
  std::map<int, const SolveRecord*> solves;
  for (const SolveRecord& solve : study.solves) {
    if (solve.solver == solver && solve.run == run) solves[solve.point] = &solve;
  }
  return solves;
}

// Three axes of one scale: a cube around the points, so that any path fits, with a round step of ticks.
std::string space_axes(const std::array<std::vector<double>, 3>& coordinates) {
  double longest = 0;
  std::array<double, 3> centre{};
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
    if (coordinates[axis].empty()) continue;
    const auto [low, high] = std::ranges::minmax(coordinates[axis]);
    centre[axis] = (low + high) / 2;
    longest = std::max(longest, high - low);
  }
  const double half = longest > 0 ? 0.55 * longest : 1;
  const double decade = std::pow(10, std::floor(std::log10(2 * half / 3)));
  const double rest = 2 * half / 3 / decade;
  const double step = decade * (rest > 7 ? 10 : rest > 3.5 ? 5 : rest > 1.5 ? 2 : 1);
  std::string settings;
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
    settings += fmt::format("set {0}range [{1}:{2}]\nset {0}tics {3} offset 0, 0\n", "xyz"[axis],
                            text_of(centre[axis] - half), text_of(centre[axis] + half), text_of(step));
  }
  return settings;
}

// 0 is a, 25 z, 26 aa.
std::string letters(std::size_t index) {
  std::string text(1, static_cast<char>('a' + index % 26));
  return index < 26 ? text : letters(index / 26 - 1) + text;
}

}  // namespace

Figure path_figure(const StudyResults& study) {
  const std::string solver = study.solves.front().solver;
  Figure figure{
      .name = "figure-5",
      .caption = fmt::format("The targets (line, dots) and where {} came to in its first run (rings).", solver),
      .height_cm = 8.0};
  figure.data = "# target x, y, z [cm]; reached x, y, z [cm] and position error [cm] of " + one_line(solver) + "\n";
  std::array<std::vector<double>, 3> coordinates;
  double largest_error = 0;
  for (const auto& [point, solve] : first_run(study, solver)) {
    if (solve->target_position_m.size() != coordinates.size()) continue;
    for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
      coordinates[axis].push_back(100 * solve->target_position_m[axis]);
      figure.data += number(coordinates[axis].back()) + ' ';
    }
    for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
      const bool known = solve->reached_position_m.size() == coordinates.size();
      figure.data += number(known ? 100 * solve->reached_position_m[axis] : not_defined) + ' ';
    }
    figure.data += number(solve->position_error_cm) + '\n';
    largest_error =
        std::isfinite(solve->position_error_cm) ? std::max(largest_error, solve->position_error_cm) : not_defined;
  }
  figure.caption += std::isfinite(largest_error)
                        ? fmt::format(" The farthest is {} cm off.", rounded_number(largest_error, 2))
                        : " Not all of its answers are finite.";
  figure.settings =
      space_axes(coordinates) +
      "set xlabel 'x [cm]'\nset ylabel 'y [cm]'\nset zlabel 'z [cm]' rotate parallel\n"
      "set view 62, 32, 1.1\nset view equal xyz\nset xyplane relative 0\nset border 127 lw 0.5 lc rgb '#AAAAAA'\n"
      "set tics textcolor rgb '#000000'\nset grid xtics ytics ztics\nunset key\n";
  figure.plot =
      "splot 'figure-5.dat' using 1:2:3 with lines lw 0.7 lc rgb '#888888', \\\n"
      "  '' using 1:2:3 with points pt 7 ps 0.35 lc rgb '#000000', \\\n"
      "  '' using 4:5:6 with points pt 6 ps 0.8 lw 0.8 lc rgb '#0072B2', \\\n"
      "  '' using 1:2:3:('start') every ::0::0 with labels right offset -0.9,0.4";
  return figure;
}

Figure curves_figure(const StudyResults& study, Metric metric) {
  Figure figure{.name = fmt::format("figure-{}", 6 + static_cast<int>(metric)),
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
    for (const auto& curve : curves) figure.data += ' ' + number(curve[point]);
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
        figure.data += ' ' + number(angle * 180 / std::numbers::pi);
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
      .name = fmt::format("figure-{}", 10 + static_cast<int>(request.metric)),
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
      const auto printed = printed_row(study.published, study.solvers[i], request.metric);
      if (!printed) continue;
      printed_marks +=
          fmt::format("{} {} {} {}\n", i + 1, number(printed->min), number(printed->median), number(printed->max));
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
    ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_string(doubled_percent(label)), i + 1);
    figure.data +=
        fmt::format("# {}\n{} {} {} {} {} {} {} {}\n", one_line(study.solvers[i]), i + 1, number(b.whisker_low),
                    number(b.q1), number(b.median), number(b.q3), number(b.whisker_high), b.n, b.not_finite);
    for (const double value : b.outliers) outliers += fmt::format("{} {}\n", i + 1, number(value));
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
  constexpr std::array<Metric, 3> metrics{Metric::position_error_cm, Metric::variation_deg, Metric::seconds};
  std::vector<Figure> figures{path_figure(study)};
  for (const Metric metric : metrics) figures.push_back(curves_figure(study, metric));
  for (Figure& figure : joint_figures(study)) figures.push_back(std::move(figure));
  for (const Metric metric : metrics) {
    figures.push_back(box_figure(study, {.metric = metric, .unit = unit, .quartiles = quartiles}));
  }
  return figures;
}

}  // namespace ikbench
