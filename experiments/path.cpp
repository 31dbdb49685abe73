#include "experiments/path.hpp"

#include <algorithm>
#include <numbers>

#include "numerics/functions.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

int points(const Path& path) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.points; }) {
          return kind.points;
        } else {
          return static_cast<int>(kind.size());
        }
      },
      path);
}

std::vector<Pose> along(const Helix& helix) {
  const int intervals = helix.spacing == Spacing::k_over_n ? helix.points : std::max(helix.points - 1, 1);
  std::vector<Pose> poses;
  for (int k = 0; k < helix.points; ++k) {
    const double fraction = static_cast<double>(k) / intervals;
    const double t = helix.start + 2 * std::numbers::pi * helix.turns * fraction;
    const auto [sine, cosine] = sin_cos(t);
    const double first = helix.phase == Phase::sin_cos ? sine : cosine;
    const double second = helix.phase == Phase::sin_cos ? cosine : sine;
    Pose pose = Pose::Identity();
    pose.linear() = rotation(helix.tool);
    pose.translation() =
        helix.centre + Eigen::Vector3d(helix.radius * first, helix.radius * second, helix.length * fraction);
    poses.push_back(pose);
  }
  return poses;
}

std::vector<Pose> along(const Circle& circle) {
  return along(Helix{.centre = circle.centre,
                     .radius = circle.radius,
                     .length = 0,
                     .turns = 1,
                     .points = circle.points,
                     .phase = Phase::cos_sin,
                     .tool = circle.tool});
}

std::vector<Pose> random_poses(const Robot& arm, int count, Random& random) {
  std::vector<Pose> poses;
  Configuration q(arm.joints());
  for (int i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(arm.limits.lower[j], arm.limits.upper[j]);
    poses.push_back(arm.kinematics->forward(q));
  }
  return poses;
}

Eigen::Matrix3d rotation(Tool tool) {
  Eigen::Matrix3d R;
  if (tool == Tool::down) {
    R << -1, 0, 0, 0, 1, 0, 0, 0, -1;
  } else {
    R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  }
  return R;
}

std::vector<double> by_rows(const Eigen::Matrix3d& R) {
  std::vector<double> elements;
  for (int row = 0; row < 3; ++row) elements.insert(elements.end(), {R(row, 0), R(row, 1), R(row, 2)});
  return elements;
}

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

}  // namespace ikbench::experiments
