// The singular values of an arm's geometric Jacobian, from poses alone.
#pragma once

#include <functional>

#include "robots/robot.hpp"

namespace ikbench::experiments {

// The tool's pose, as a 4 x 4 matrix, with one joint at another value. It is a + b cos q + c sin q for a joint that
// turns and a + b q for one that slides, so its derivative is exactly half the difference of the poses a quarter turn,
// or a metre, to both sides.
using PoseWith = std::function<Eigen::Matrix4d(Eigen::Index joint, double value)>;

// The singular values, largest first: as many as the smaller of 6 and the number of joints; a single NaN if the
// Jacobian is not finite. Its rows are the tool's velocity [m] and turning rate [rad], per rad of a joint, or per m if
// it slides. `pose` is the tool's pose at `q`.
Eigen::VectorXd singular_values(const robots::Robot& arm, const Eigen::VectorXd& q, const Eigen::Matrix4d& pose,
                                const PoseWith& pose_with);

}  // namespace ikbench::experiments
