// A judged study and an arm as rows of plots.hpp. All runs are in curves and boxes; what has one value a point shows
// the first run of each solver.
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

// The solvers that figures show, in their order; of more lines than are drawn the study's own first.
std::vector<std::string> drawn_solvers(const judge::StudyResults& study, const Look& look, bool as_lines = false);

// Values are drawn times `factor`: 10 for cm in mm.
struct DrawnUnit {
  std::string name;
  double factor = 1;
};
DrawnUnit drawn_unit(const judge::StudyResults& study, std::string_view unit);
// Returns a row of boxes for each of these names, in their order.
std::vector<BoxRow> box_rows(const judge::MetricSamples& samples, const DrawnUnit& unit,
                             const std::vector<std::string>& shown, const Look& look);
// Medians of all runs with their quartiles, or means.
enum class Average { median, mean };
std::vector<Line> by_point(const judge::StudyResults& study, std::string_view column, const Look& look,
                           Average average);
// The best error after each iteration, of all solves; those that ended earlier keep their last. Solvers without a trace
// have no row.
std::vector<Line> by_iteration(const judge::StudyResults& study, const Look& look, Average average);
// Returns the angles of the revolute joints in each solver's first run; without rows for an unknown arm.
JointRows joint_rows(const judge::StudyResults& study, const Look& look);

// The corners of an arm from the base to the tool: the origins of a description's joints, or the ends of the table's
// steps along z and x.
std::vector<Corner> corners_of(const robots::Robot& arm, const Eigen::VectorXd& q);

}  // namespace ikbench::figures
