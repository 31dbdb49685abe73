// Rotations of a tool, as study files and stores say them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/fields.hpp"

namespace ikbench::experiments {

// How the tool is held along a path: down is R = diag(-1, 1, -1); eq27 has (0, 1, 0) as its third column, a horizontal
// tool, as Eq. 27 prints (its other columns are our choice).
enum class Tool { down, eq27 };

void list_tool(Fields& io, Tool& tool);
Eigen::Matrix3d rotation(Tool tool);
// The nine elements of a rotation, row by row.
std::vector<double> by_rows(const Eigen::Matrix3d& R);

}  // namespace ikbench::experiments
