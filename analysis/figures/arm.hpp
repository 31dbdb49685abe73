// The places of the joints of an arm, for drawing it.
#pragma once

#include <array>
#include <vector>

#include "robots/robot.hpp"

namespace ikbench::figures {

using Point = std::array<double, 3>;  // x, y, z [m]

// The corners from the base to the tool: the origins of a description's joints, or the ends of the table's steps along
// z and x.
std::vector<Point> arm_points(const robots::Robot& arm, const Eigen::VectorXd& q);
}  // namespace ikbench::figures
