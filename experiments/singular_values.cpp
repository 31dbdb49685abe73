#include "experiments/singular_values.hpp"

#include <Eigen/SVD>
#include <limits>
#include <numbers>

namespace ikbench::experiments {

Eigen::VectorXd singular_values(const robots::Robot& arm, const Eigen::VectorXd& q, const Eigen::Matrix4d& pose,
                                const PoseWith& pose_with) {
  Eigen::MatrixXd jacobian(6, q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const bool slides = arm.chain.links()[static_cast<std::size_t>(j)].joint == robots::Joint::slides;
    const double step = slides ? 1 : std::numbers::pi / 2;
    const Eigen::Matrix4d after = pose_with(j, q[j] + step), before = pose_with(j, q[j] - step);
    const Eigen::Matrix4d rate = (after - before) / 2;
    const Eigen::Matrix3d turn = rate.topLeftCorner<3, 3>() * pose.topLeftCorner<3, 3>().transpose();
    jacobian.col(j) << rate.topRightCorner<3, 1>(), turn(2, 1), turn(0, 2), turn(1, 0);
  }
  if (!jacobian.allFinite()) return Eigen::VectorXd::Constant(1, std::numeric_limits<double>::quiet_NaN());
  return Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
}

}  // namespace ikbench::experiments
