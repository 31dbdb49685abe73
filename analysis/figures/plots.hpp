// The kinds of figures, as functions of rows; none knows a study. Values that are not finite are not drawn, and a
// figure that would have no mark is none. A style is a number of style.gp's line styles: the colour of a solver in
// every figure (look.hpp).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/figures/figure.hpp"

namespace ikbench::figures {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_lines = 7;  // that can be told apart; the data file has all

// Groups of values, a row each: a box of the quartiles, whiskers to the smallest and the largest, and the values; in
// grey what a paper printed. What is infinite is at the edge.
struct BoxRow {
  std::string label;
  int style = 1;
  std::vector<double> values = {};
  std::array<double, 5> box = {nowhere, nowhere, nowhere, nowhere, nowhere};  // smallest, quartiles, largest
  std::array<double, 3> printed = {nowhere, nowhere, nowhere};                // smallest, median, largest
  std::string remark = {};                                                    // at the right: "3 missing"
};
std::optional<Figure> boxes(const About& about, const std::vector<BoxRow>& rows);

// Figures of lines (curves, shares, joints) show the first seven. The data file has all; the caption names those left
// out.

// Curves of y by x with the band from low to high, the quartiles.
struct CurveRow {
  double x, y, low = nowhere, high = nowhere;
};
struct Line {
  std::string label;
  int style = 1;  // 0: grey rings, of printed numbers
  std::vector<CurveRow> rows = {};
};
std::optional<Figure> curves(const About& about, const std::string& x_axis, std::vector<Line> all);

// How many of all attempts had succeeded at this cost, a share on `y_axis`; dashed, if known, a cost that matters.
struct Successes {
  std::string label;
  int style = 1;
  std::vector<double> costs = {};  // of those that succeeded
  std::size_t attempts = 0;
};
std::optional<Figure> shares(const About& about, const std::string& y_axis, const std::vector<Successes>& all,
                             double dashed = nowhere);

// Solvers by their place, a row each; at the right bars that join those that are not apart from one another; below a
// length to hold against the places.
struct RankRow {
  std::string label;
  int style = 1;
  double place = nowhere;
  std::vector<std::string> apart = {};  // labels
};
std::optional<Figure> ranks(const About& about, const std::vector<RankRow>& rows, double ruler = nowhere);

// Intervals, a row each: differences, or ratios on a logarithmic axis. At the right of a row who is better, or what
// else is known.
struct IntervalRow {
  std::string label;  // "BA -\nDE"
  double estimate = nowhere, low = nowhere, high = nowhere;
  std::string verdict = {};
  int style = 0;  // of the better one; 0: grey
};
std::optional<Figure> differences(const About& about, const std::vector<IntervalRow>& rows, bool are_ratios);

using Corner = Eigen::Vector3d;  // [cm]
struct PathRows {
  std::vector<Corner> targets = {}, reached = {}, late_or_too_fast = {};
  std::vector<std::pair<std::string, std::vector<Corner>>> arms = {};  // label, and corners from the base to the tool
  std::string reached_label = "reached";
  int style = 1;  // of what was reached
};
// Targets as a path, what was reached at each, and arms.
Figure path(const About& about, const PathRows& rows);

// A row of panels a solver, a panel a joint. Letters (a), (b), ... if there are several; rings where an angle is
// outside its limits, which are dashed.
struct JointRow {
  std::string label;
  int style = 1;
  std::vector<std::vector<double>> angles_deg = {};  // by point, of each joint of the columns
};
struct JointColumn {
  std::string label;
  double lower_deg = nowhere, upper_deg = nowhere;
};
struct JointRows {
  std::vector<JointRow> rows;
  std::vector<JointColumn> columns;
};
std::optional<Figure> joints(const About& about, const JointRows& all_rows);

// A dot a solver, of two quantities; a ring is what a paper printed.
struct Dot {
  std::string label;
  int style = 1;
  double x = nowhere, y = nowhere, printed_x = nowhere, printed_y = nowhere;
};
std::optional<Figure> overview(const About& about, const std::string& x_axis, const std::vector<Dot>& dots);

}  // namespace ikbench::figures
