// Rotations as matrices, angles and vectors.
#pragma once

#include <Eigen/Core>

namespace ikbench::robots {

// Returns R = Rz(yaw) Ry(pitch) Rx(roll) for roll, pitch, yaw [rad].
Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy);

// Returns the rotation vector of R: its axis times its angle, 0 to pi [rad], which is the logarithm of R. The error is
// within 1e-15 rad near the identity, and within 1e-12 rad everywhere. For half a turn the axis has one of its two
// directions.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R);

// Returns the rotation vector [rad] of the shortest turn from one direction to another, both of length 1. Between
// opposite directions it is one of the shortest turns.
Eigen::Vector3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace ikbench::robots
