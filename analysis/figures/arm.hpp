// The places of the joints of an arm, for drawing it.
#pragma once

#include <array>
#include <vector>

#include "analysis/inference/study_facts.hpp"
#include "robots/robot.hpp"

namespace ikbench::figures {

using Point = std::array<double, 3>;  // x, y, z [m]

// The corners from the base to the tool: the origins of a description's joints, or the ends of the table's steps along
// z and x.
std::vector<Point> arm_points(const robots::Robot& arm, const Eigen::VectorXd& q);
// Returns the corners of the study's arm; none where the definition has no arm, or the angles are not those of its
// joints.
std::vector<Point> arm_points(const inference::StudyFacts& facts, const std::vector<double>& angles_rad);

}  // namespace ikbench::figures
