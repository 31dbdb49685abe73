// What the figures of a study have in common: names, axes, legends, and the solves that they show.
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

constexpr std::string_view grey_rings = "pt 6 ps 0.9 lc rgb '#808080'";  // what a paper printed
constexpr std::size_t longest_label = 28;  // characters of a solver's label in a figure; the data file has all

std::string data_number(double value);  // as a data file has it

// "0.0017 cm"; times in the unit that suits them.
std::string value_words(inference::Metric metric, double value);

std::string tick_label(std::string_view text);  // a label is a format to gnuplot: %% is %

// Says what a reader of the picture must know.
std::string with_notes(std::string caption, const inference::StudyResults& study, inference::Metric metric,
                       const Axis& axis);
// The legend below the plot, in as many columns as fit, and the room that it takes.
void add_legend(Figure& figure, const std::vector<std::string>& labels);
// Ticks at whole points: 1 and multiples of a round step.
std::string point_axis(int points);
// Three axes of one scale: a cube around the points [cm], so that any path fits, with a round step of ticks.
std::string space_axes(const std::array<std::vector<double>, 3>& coordinates_cm);
// A line a point: its number, then the values.
std::string lines_by_point(const std::map<int, std::vector<double>>& values);
std::string plot_command(const std::vector<std::string>& clauses, std::string_view command = "plot");

// Average over the runs at every point (inference::average_of); a mean with an answer that is not finite is not
// defined.
std::vector<double> averages_by_point(const inference::StudyResults& study, const std::string& solver,
                                      inference::Metric metric);
// The first run that the solver has, by point.
std::map<int, const results::SolveRecord*> first_run(const inference::StudyResults& study, const std::string& solver);
// Of each of those, all joints [deg]; not defined where an answer has fewer joints than another.
std::map<int, std::vector<double>> joint_angles_deg(const std::map<int, const results::SolveRecord*>& solves);

}  // namespace ikbench::figures
