// What the kinds of figures share: labels, numbers of data files, axes, rows and legends, as gnuplot commands.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"

namespace ikbench::figures {

// Any text as an expression, at most 60 characters of it. Characters that mean something to gnuplot become elements of
// style.gp's array `character`.
std::string gnuplot_text(std::string_view text);

// Sets x_title or y_title, unless a style did.
std::string title_of(char letter, std::string_view title);

// A line of numbers. "NaN" for what is not drawn; 1e300 for infinity: gnuplot needs room for an axis around.
std::string data_row(const std::vector<double>& values);

std::string plotted(const std::vector<std::string>& clauses);

// The smallest of 1, 2 and 5 times a power of ten that marks at most `places` places of a span.
double round_step_of(double span, double places);

// "lc rgb colour_of(3)"; of 0 grey.
std::string colour_of(int style);

double width_cm_of(std::string_view label);  // approximately

// An axis: its commands, which set title, range and ticks, and the function place_x(v) or place_y(v) of values within
// the range. That of values is logarithmic if none is negative, they span a factor of 30 and are no shares; then values
// up to the floor are at its edge, which says so.
struct Axis {
  std::string settings;
  double low = 0, high = 1;  // of the range
  bool is_logarithmic = false;
  double edge = -std::numeric_limits<double>::infinity();  // smaller values stand at it

  double share_of(double value) const;  // 0 at the low end, 1 at the high one
};
enum class Begins { at_zero, around, at_first };
Axis value_axis(char letter, std::span<const double> values, const About& about, Begins begins);
Axis linear_axis(char letter, std::span<const double> values, const std::string& title, Begins begins);
Axis logarithmic_axis(char letter, double smallest, double largest, const std::string& title);

// Rows 1, 2, ... from the top with their labels, of a line or more, at the left. Sets the figure's size.
void add_labelled_rows(Figure& figure, const std::vector<std::string>& labels, double row_cm);
// Names with their markers: at the right of the plot, each joined to its mark, or below, in two columns or one, where
// they would take too much of the width. None for a single one. Sets the margins.
struct Named {
  std::string label;
  int style = 1;        // 0: grey
  double y = 0, x = 1;  // shares of the axes; by default the end of a line
};
void add_names(Figure& figure, std::vector<Named> marks);
// Room for so many entries below the plot, a row each; none for a single one.
void add_legend(Figure& figure, std::size_t entries);

}  // namespace ikbench::figures
