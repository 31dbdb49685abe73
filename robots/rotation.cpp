#include "robots/rotation.hpp"

#include <Eigen/Geometry>

#include "numerics/functions.hpp"

namespace ikbench::robots {

using namespace numerics;

Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy) {
  const auto [sr, cr] = sin_cos(rpy[0]);
  const auto [sp, cp] = sin_cos(rpy[1]);
  const auto [sy, cy] = sin_cos(rpy[2]);
  Eigen::Matrix3d R;                                             // Rz(yaw) Ry(pitch) Rx(roll)
  R << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,   //
      -sp, cp * sr, cp * cr;
  return R;
}

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d skew =
      0.5 * Eigen::Vector3d(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));  // sine times axis
  const double sine = skew.norm(), cosine = 0.5 * (R.trace() - 1), angle = arc_tangent(sine, cosine);
  if (cosine > 0) return sine > 0 ? Eigen::Vector3d(angle / sine * skew) : skew;
  // Towards half a turn the sine goes to 0, but (R + R^T) / 2 - cosine I = (1 - cosine) axis axis^T stays.
  Eigen::Index largest = 0;
  R.diagonal().maxCoeff(&largest);
  Eigen::Vector3d axis = 0.5 * (R.col(largest) + R.row(largest).transpose());
  axis[largest] -= cosine;
  axis /= axis.norm();
  return (dot(axis, skew) < 0 ? -angle : angle) * axis;
}

Eigen::Vector3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d cross = from.cross(to);
  const double sine = cross.norm(), angle = arc_tangent(sine, dot(from, to));
  return sine > 0 ? Eigen::Vector3d(angle / sine * cross) : Eigen::Vector3d(angle * from.unitOrthogonal());
}

}  // namespace ikbench::robots
