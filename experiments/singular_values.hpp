// The singular values of an arm's geometric Jacobian, from poses alone.
#pragma once

#include <functional>

#include "robots/robot.hpp"

namespace ikbench::experiments {

// The tool's pose, as a 4 x 4 matrix, with one joint at another value: a + b cos q + c sin q of a joint that turns and
// a + b q of one that slides, so that its derivative is exactly half the difference of the poses a quarter turn, or a
// metre, to both sides.
using PoseWith = std::function<Eigen::Matrix4d(Eigen::Index joint, double value)>;

// Rows of the Jacobian: the tool's velocity [m] and rate of turn [rad], per rad of a joint, or per m where it slides.
// As many as the smaller of 6 and the number of joints, largest first; a single NaN where the Jacobian is not finite.
// `pose` is the tool's at `q`.
Eigen::VectorXd singular_values(const robots::Robot& arm, const Eigen::VectorXd& q, const Eigen::Matrix4d& pose,
                                const PoseWith& pose_with);

}  // namespace ikbench::experiments
