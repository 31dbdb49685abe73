// The singular values of an arm's geometric Jacobian, from poses alone.
#pragma once

#include <Eigen/SVD>
#include <limits>
#include <numbers>

#include "robots/robot.hpp"

namespace ikbench::experiments {

// Rows: the tool's velocity [m] and rate of turn [rad], per rad of a joint, or per m where it slides. As many as the
// smaller of 6 and the number of joints, largest first; a single NaN where the Jacobian is not finite. `pose_at(q)` is
// the tool's pose as a 4 x 4 matrix: a + b cos q + c sin q of each joint that turns and a + b q of one that slides, so
// that its derivative is exactly half the difference of the poses a quarter turn, or a metre, to both sides.
template <class PoseAt>
Eigen::VectorXd singular_values(const robots::Robot& arm, const Eigen::VectorXd& q, PoseAt pose_at) {
  const Eigen::Matrix4d pose = pose_at(q);
  Eigen::MatrixXd jacobian(6, q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const bool slides = arm.chain.links()[static_cast<std::size_t>(j)].joint == robots::Joint::slides;
    const Eigen::VectorXd step = Eigen::VectorXd::Unit(q.size(), j) * (slides ? 1 : std::numbers::pi / 2);
    const Eigen::Matrix4d after = pose_at(q + step), before = pose_at(q - step), rate = (after - before) / 2;
    const Eigen::Matrix3d turn = rate.topLeftCorner<3, 3>() * pose.topLeftCorner<3, 3>().transpose();
    jacobian.col(j) << rate.topRightCorner<3, 1>(), turn(2, 1), turn(0, 2), turn(1, 0);
  }
  if (!jacobian.allFinite()) return Eigen::VectorXd::Constant(1, std::numeric_limits<double>::quiet_NaN());
  return Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
}

}  // namespace ikbench::experiments
