#include "experiments/orientation.hpp"

#include "numerics/functions.hpp"

namespace ikbench::experiments {

using namespace numerics;

void list_tool(Fields& io, Tool& tool) {
  io.choice("tool", tool, Choices<Tool>{{"down", Tool::down}, {"eq27", Tool::eq27}},
            "how the tool is held: straight down, or as Eq. 27 prints it (horizontal)");
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
