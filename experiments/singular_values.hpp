// The singular values of an arm's geometric Jacobian.
#pragma once

#include <Eigen/Core>

#include "robots/kernels.hpp"

namespace ikbench::experiments {

// A column a joint: the tool's velocity [m] and turning rate [rad], per rad of the joint, or per m if it slides.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, robots::most_joints>;

// Largest first, as many as the smaller of 6 and the number of joints; a single NaN if the Jacobian is not finite.
Eigen::VectorXd singular_values(const Jacobian& jacobian);

}  // namespace ikbench::experiments
