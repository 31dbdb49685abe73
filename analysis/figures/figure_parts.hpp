// Common parts of a study's figures: names, axes, legends, and the solves that they show.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::figures {

constexpr std::string_view grey_rings = "pt 6 ps 0.9 lc rgb '#808080'";  // for printed numbers
constexpr std::size_t longest_label = 28;  // characters of a solver's label in a figure; the data file has all

std::string data_number(double value);  // in the format of a data file

// "0.0017 cm"; times in a suitable unit.
std::string value_words(inference::Metric metric, double value);

std::string tick_label(std::string_view text);  // gnuplot takes a label as a format: %% is %

// Adds what a reader of the picture must know.
std::string with_notes(std::string caption, const inference::StudyResults& study, inference::Metric metric,
                       const Axis& axis);
// Adds the legend below the plot, in as many columns as fit, and room for it.
void add_legend(Figure& figure, const std::vector<std::string>& labels);
// Ticks at whole points: 1 and multiples of a round step.
std::string point_axis(int points);
// Three axes of one scale: a cube around the points [cm], so that any path fits, with a round step of ticks.
std::string space_axes(const std::array<std::vector<double>, 3>& coordinates_cm);
// One line per point: its number, then the values.
std::string lines_by_point(const std::map<int, std::vector<double>>& values);
std::string plot_command(const std::vector<std::string>& clauses, std::string_view command = "plot");

// Averages over the runs at every point (inference::average_of); not defined if an answer is not finite and the average
// is a mean.
std::vector<double> averages_by_point(const inference::StudyResults& study, const std::string& solver,
                                      inference::Metric metric);
// The solver's first run, by point.
std::map<int, const results::SolveRecord*> first_run(const inference::StudyResults& study, const std::string& solver);
// All joints [deg] at each point; not defined if an answer has fewer joints than another.
std::map<int, std::vector<double>> joint_angles_deg(const std::map<int, const results::SolveRecord*>& solves);

}  // namespace ikbench::figures
