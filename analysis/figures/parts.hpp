// The gnuplot commands that all kinds of figures share: labels, numbers of data files, axes, rows and legends.
// plots.cpp makes figures of these parts.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"

namespace ikbench::figures {

// Returns any text as a gnuplot expression of at most 60 characters of the text. Characters that mean something to
// gnuplot become elements of style.gp's array `character`.
std::string gnuplot_text(std::string_view text);

// Returns the command that sets x_title or y_title (by `letter`), unless a style has set the title.
std::string title_of(char letter, std::string_view title);

// Returns a line of a data file. NaN is "NaN" and not drawn. Infinity is 1e300, because gnuplot needs room for an axis
// around the largest number.
std::string data_row(const std::vector<double>& values);

// Returns the plot command of these clauses.
std::string plotted(const std::vector<std::string>& clauses);

// Returns the smallest of 1, 2 and 5 times a power of ten that marks at most `places` places of a span.
double round_step_of(double span, double places);

// Returns "lc rgb colour_of(3)" for style 3, and the same for grey if the style is 0.
std::string colour_of(int style);

// Returns the approximate width of a label [cm].
double width_cm_of(std::string_view label);

// An axis of a figure. The settings set the title, the range and the ticks, and define the function place_x(v) or
// place_y(v) for values within the range.
struct Axis {
  std::string settings;
  double low = 0, high = 1;  // of the range
  bool is_logarithmic = false;
  double edge = -std::numeric_limits<double>::infinity();  // smaller values stand at the edge

  // Returns the place of a value on the axis: 0 at the low end, 1 at the high end.
  double share_of(double value) const;
};
// Where a linear axis begins: at zero, around the values, or at the first value.
enum class Begins { at_zero, around, at_first };
// Returns the axis of these values. The axis is logarithmic if no value is negative, the values span a factor of 30 and
// are no shares. Values up to the floor then stand at the edge of the axis, where a tick says so.
Axis value_axis(char letter, std::span<const double> values, const About& about, Begins begins);
Axis linear_axis(char letter, std::span<const double> values, const std::string& title, Begins begins);
Axis logarithmic_axis(char letter, double smallest, double largest, const std::string& title);

// Adds rows 1, 2, ... from the top with labels at the left, which may have several lines. Sets the figure's size.
void add_labelled_rows(Figure& figure, const std::vector<std::string>& labels, double row_cm);
// The name of a mark in a plot.
struct Named {
  std::string label;
  int style = 1;        // 0: grey
  double y = 0, x = 1;  // shares of the axes; by default the end of a line
};
// Adds the names of marks at the right of the plot, each joined to the mark. Names that would take too much of the
// width stand below the plot, in one or two columns. A single name is not added. Sets the margins.
void add_names(Figure& figure, std::vector<Named> marks);
// Adds room for a legend below the plot, with a row per entry. A single entry needs no legend.
void add_legend(Figure& figure, std::size_t entries);

}  // namespace ikbench::figures
