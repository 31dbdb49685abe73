// The kinds of figures, as functions of rows, which know no study (rows.hpp makes rows of studies). Unless a comment
// says otherwise, values that are not finite are not drawn. A figure that would have no mark is nullopt. A style is the
// number of a line style of style.gp: the colour of a solver in every figure (look.hpp).
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

// The coordinate of a mark that is not drawn.
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
// The most lines that can be distinguished in one figure.
constexpr std::size_t most_lines = 7;

// A group of values in a figure of boxes: a box of the quartiles, whiskers to the smallest and the largest value, and
// the values. The printed numbers of a paper are grey. Infinite values stand at the edge.
struct BoxRow {
  std::string label;
  int style = 1;
  std::vector<double> values = {};
  std::array<double, 5> box = {nowhere, nowhere, nowhere, nowhere, nowhere};  // smallest, quartiles, largest
  std::array<double, 3> printed = {nowhere, nowhere, nowhere};                // smallest, median, largest
  std::string remark = {};                                                    // at the right: "3 missing"
};
// Returns a figure with a row of boxes per group.
std::optional<Figure> boxes(const About& about, const std::vector<BoxRow>& rows);

// Figures of lines (curves, shares, joints) show the first most_lines lines. The data file has all lines, and the
// caption names the lines that are left out.

// A point of a curve, with a band from low to high.
struct CurveRow {
  double x, y, low = nowhere, high = nowhere;
};
// A curve of y by x.
struct Line {
  std::string label;
  int style = 1;  // 0: grey rings, of printed numbers
  std::vector<CurveRow> rows = {};
};
// The x axis of a figure of curves, and how `low` and `high` are drawn.
struct CurveAxis {
  std::string title;
  bool has_bars = false;            // bars, which are 95 % intervals; otherwise bands, which are quartiles
  bool may_be_logarithmic = false;  // if the values span a factor of 30
};
// Returns a figure of curves.
std::optional<Figure> curves(const About& about, const CurveAxis& axis, std::vector<Line> all);

// The costs of a solver's successes among all attempts.
struct Successes {
  std::string label;
  int style = 1;
  std::vector<double> costs = {};  // one per success
  std::size_t attempts = 0;
};
// Returns a figure of the share of attempts that had succeeded at each cost. A dashed line marks the cost `dashed`.
std::optional<Figure> shares(const About& about, const std::string& y_axis, const std::vector<Successes>& all,
                             double dashed = nowhere);

// A solver in a figure of places.
struct RankRow {
  std::string label;
  int style = 1;
  double place = nowhere;
  std::vector<std::string> apart = {};  // labels of the solvers that differ from this one
};
// Returns a figure with a row per solver by place. Bars at the right join solvers that are not apart from one another.
// Below stands a length of `ruler`, with which distances of places can be compared.
std::optional<Figure> ranks(const About& about, const std::vector<RankRow>& rows, double ruler = nowhere);

// A pair of solvers in a figure of differences.
struct IntervalRow {
  std::string label;  // "BA -\nDE"
  double estimate = nowhere, low = nowhere, high = nowhere;
  std::string verdict = {};  // at the right: the better solver, or another verdict
  int style = 0;             // of the better solver; 0: grey
};
// Returns a figure with an interval per row: differences, or ratios on a logarithmic axis.
std::optional<Figure> differences(const About& about, const std::vector<IntervalRow>& rows, bool are_ratios);

// The targets that a solver solves.
struct SolvedRow {
  std::string label;
  int style = 1;
  std::vector<bool> is_solved = {};  // of each target
};
// Returns a figure with a row per solver, filled where the solver solves a target. The targets stand in the order of
// the rows' values, and those from `solvable` on, which no solver solves, are grey.
Figure solved_rows(const About& about, const std::vector<SolvedRow>& rows, std::size_t solvable);

using Corner = Eigen::Vector3d;  // [cm]
// The targets of a run, the reached positions, and drawings of the arm.
struct PathRows {
  std::vector<Corner> targets = {}, reached = {}, late_or_too_fast = {};
  std::vector<std::pair<std::string, std::vector<Corner>>> arms = {};  // label, and corners from the base to the tool
  std::string reached_label = "reached";
  int style = 1;  // of the reached positions
};
// Returns a figure of the targets as a path, the position reached at each target, and the arms.
Figure path(const About& about, const PathRows& rows);

// The joint angles of a solver.
struct JointRow {
  std::string label;
  int style = 1;
  std::vector<std::vector<double>> angles_deg = {};  // by point, of each joint of the columns
};
// A joint and the joint's limits.
struct JointColumn {
  std::string label;
  double lower_deg = nowhere, upper_deg = nowhere;
};
// The joint angles of all solvers.
struct JointRows {
  std::vector<JointRow> rows;
  std::vector<JointColumn> columns;
};
// Returns a figure with a row of panels per solver and a panel per joint. Several panels have letters (a), (b), ... The
// limits are dashed, and rings mark angles outside the limits.
std::optional<Figure> joints(const About& about, const JointRows& all_rows);

// A solver in a figure of two quantities.
struct Dot {
  std::string label;
  int style = 1;
  double x = nowhere, y = nowhere, printed_x = nowhere, printed_y = nowhere;
};
// Returns a figure with a dot per solver, and a ring for the numbers that a paper printed.
std::optional<Figure> overview(const About& about, const std::string& x_axis, const std::vector<Dot>& dots);

}  // namespace ikbench::figures
