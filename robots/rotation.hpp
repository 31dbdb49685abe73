// Rotations as vectors.
#pragma once

#include <Eigen/Core>

namespace ikbench::robots {

// R = Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy);

// The axis of a rotation times its angle, 0 to pi [rad]: the logarithm of R. Within 1e-15 rad near the identity, and
// 1e-12 everywhere. The axis of half a turn has two directions; it gives one of them.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R);

}  // namespace ikbench::robots
