// Common parts of a study's figures: names, axes, legends, and the solves that they show.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::figures {

constexpr std::string_view grey_rings = "pt 6 ps 0.9 lc rgb '#808080'";  // for printed numbers
constexpr std::size_t longest_label = 36;  // characters of a solver's label in a figure; the data file has all

// A number, and a line of numbers, of a data file.
std::string data_number(double value);
std::string data_line(const std::vector<double>& values);

// "0.0017 cm"; times in a suitable unit.
std::string value_words(inference::Metric metric, double value);

std::string tick_label(std::string_view text);  // gnuplot takes a label as a format: %% is %

// Adds what a reader of the picture must know.
std::string with_notes(std::string caption, const inference::StudyResults& study, inference::Metric metric,
                       const Axis& axis);
// Approximate width of a label in 7 pt text.
double label_cm(std::string_view label);
// Adds rows 1, 2, ... from the top with their labels at the left, and sets the figure's size.
void add_rows(Figure& figure, const std::vector<std::string>& labels, double row_cm);

// Adds the legend below the plot, in as many columns as fit, and room for it.
void add_legend(Figure& figure, const std::vector<std::string>& labels);
// Ticks at whole points: 1 and multiples of a round step.
std::string point_axis(int points);
// Three axes of one scale: a cube around the points [cm], so that any path fits, with a round step of ticks.
std::string space_axes(const std::array<std::vector<double>, 3>& coordinates_cm);
// One line per point: its number, then the values.
std::string lines_by_point(const std::map<int, std::vector<double>>& values);
std::string plot_command(const std::vector<std::string>& clauses, std::string_view command = "plot");

// A curve with a band as rows of a data file: x, y, low, high.
struct Curve {
  std::string rows = {};
  std::size_t count = 0;                                       // of its rows; 0: there is nothing to show
  std::size_t band = std::numeric_limits<std::size_t>::max();  // its first row

  void add(double x, const statistics::Estimate& y);
};
constexpr std::size_t most_bands = 6;  // more would cover each other
// Adds a curve for each solver of the study, and its band if there are at most most_bands; returns the legend's labels.
// The settings must define shown_x(x) and shown(y), the drawn places. `clauses` are drawn behind the curves. Without
// `with` (linespoints or points), a curve is a line with about nine markers, which begin elsewhere than the next
// solver's.
std::vector<std::string> add_curves(Figure& figure, const inference::StudyResults& study,
                                    const std::vector<Curve>& curves, std::vector<std::string> clauses = {},
                                    std::string_view with = "");

// The values of all runs at every point.
std::vector<std::vector<double>> values_by_point(const inference::StudyResults& study, const std::string& solver,
                                                 inference::Metric metric);
// The solver's first run, by point.
std::map<int, const results::SolveRecord*> first_run(const inference::StudyResults& study, const std::string& solver);
// All joints [deg] at each point; not defined if an answer has fewer joints than another.
std::map<int, std::vector<double>> joint_angles_deg(const std::map<int, const results::SolveRecord*>& solves);

}  // namespace ikbench::figures
