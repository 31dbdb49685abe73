// Makes rows for the figures of plots.hpp from a study and an arm. Curves and boxes have all runs. Figures with one
// value per point, such as joint angles, show the first run of each solver.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/look.hpp"
#include "analysis/figures/plots.hpp"
#include "analysis/judge/judge.hpp"
#include "robots/robot.hpp"

namespace ikbench::figures {

// Returns the subject of a figure of this metric, in the unit that figures have.
About about_of(const judge::StudyResults& study, const judge::Metric& metric, std::string caption);

// Returns the solvers that figures show, in order. If the solvers are more lines than a figure draws, the study's own
// solvers (Look::own) come first.
std::vector<std::string> drawn_solvers(const judge::StudyResults& study, const Look& look, bool as_lines = false);

// A unit of figures. Values are multiplied by `factor` before they are drawn: by 10 for cm in mm.
struct DrawnUnit {
  std::string name;
  double factor = 1;
};
// Returns the unit in which figures of the study show values of `unit`.
DrawnUnit drawn_unit(const judge::StudyResults& study, std::string_view unit);
// Returns a row of boxes for each of these names, in their order.
std::vector<BoxRow> box_rows(const judge::MetricSamples& samples, const DrawnUnit& unit,
                             const std::vector<std::string>& shown, const Look& look);
// The average of all runs that a curve shows: the median with the quartiles, or the mean.
enum class Average { median, mean };
// Returns a curve per solver of a column's values by point.
std::vector<Line> by_point(const judge::StudyResults& study, std::string_view column, const Look& look,
                           Average average);
// Returns a curve per solver of the best error after each iteration, over all solves. A solve that ended earlier keeps
// the last error. Solvers without a trace have no curve.
std::vector<Line> by_iteration(const judge::StudyResults& study, const Look& look, Average average);
// Returns the angles of the revolute joints in each solver's first run. Without rows if the arm is unknown.
JointRows joint_rows(const judge::StudyResults& study, const Look& look);

// Returns the corners of an arm at the configuration `q` [rad, m], from the base to the tool: the origins of the joints
// of a robot description, or the ends of the steps along z and x of a Denavit-Hartenberg table.
std::vector<Corner> corners_of(const robots::Robot& arm, const Eigen::VectorXd& q);

}  // namespace ikbench::figures
