// Rotations as vectors.
#pragma once

#include <Eigen/Core>

namespace ikbench::robots {

// R = Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy);

// The axis of a rotation times its angle, 0 to pi [rad]: the logarithm of R. Within 1e-15 rad near the identity, and
// 1e-12 everywhere. The axis of half a turn has two directions; it gives one of them.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R);

// The rotation vector of the shortest turn from a direction to another, both of length 1; between opposite ones, one of
// the shortest.
Eigen::Vector3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace ikbench::robots
