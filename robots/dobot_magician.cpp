#include "robots/dobot_magician.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "numerics/functions.hpp"
#include "numerics/kernels.hpp"

namespace ikbench::robots {

using namespace numerics;

Pose DobotMagician::forward(const ConfigurationRef& q) const {
  const auto [s1, c1] = sin_cos(q[0]);
  const auto [s2, c2] = sin_cos(q[1]);
  const auto [s3, c3] = sin_cos(q[2]);
  const double radius = upper_arm * s2 + forearm * c3 + wrist_to_tool;
  Pose T_base_tool = Pose::Identity();
  T_base_tool.linear() << c1, -s1, 0, s1, c1, 0, 0, 0, 1;  // the linkage keeps the tool upright
  T_base_tool.translation() << radius * c1, radius * s1, upper_arm * c2 - forearm * s3 + height;
  return T_base_tool;
}

Eigen::Vector3d DobotMagician::linearize(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const {
  const auto [s1, c1] = sin_cos(q[0]);
  const auto [s2, c2] = sin_cos(q[1]);
  const auto [s3, c3] = sin_cos(q[2]);
  const Eigen::Vector3d tool = position(q);
  jacobian.col(0) << -tool.y(), tool.x(), 0;
  jacobian.col(1) << upper_arm * c2 * c1, upper_arm * c2 * s1, -upper_arm * s2;
  jacobian.col(2) << -forearm * s3 * c1, -forearm * s3 * s1, -forearm * c3;
  return tool;
}

void DobotMagician::position_errors(const CandidatesRef& q, const Eigen::Vector3d& target,
                                    Eigen::Ref<Eigen::VectorXd> errors) const {
  constexpr Eigen::Index batch = 64;
  std::array<std::array<double, batch>, 3> sines, cosines;
  for (Eigen::Index first = 0; first < q.cols(); first += batch) {
    const Eigen::Index count = std::min(batch, q.cols() - first);
    for (std::size_t j = 0; j < 3; ++j) {
      const double* const angles = q.data() + static_cast<Eigen::Index>(j) * q.outerStride() + first;
      numerics::kernels().sines_and_cosines(angles, count, sines[j].data(), cosines[j].data());
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const double radius = upper_arm * sines[1][i] + forearm * cosines[2][i] + wrist_to_tool;
      const double dx = radius * cosines[0][i] - target.x(), dy = radius * sines[0][i] - target.y();
      const double dz = upper_arm * cosines[1][i] - forearm * sines[2][i] + height - target.z();
      errors[first + static_cast<Eigen::Index>(i)] = std::sqrt(dx * dx + dy * dy + dz * dz);  // Eq. 1
    }
  }
}

Kinematics::Ball DobotMagician::reach() const { return {{0, 0, height}, upper_arm + forearm + wrist_to_tool}; }

std::string DobotMagician::definition() const {
  return fmt::format(" dobot magician {} {} {} {} ", upper_arm, forearm, wrist_to_tool, height);
}

}  // namespace ikbench::robots
