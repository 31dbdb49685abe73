#include "experiments/orientation.hpp"

#include <algorithm>

#include "numerics/units.hpp"
#include "robots/rotation.hpp"

namespace ikbench::experiments {

using namespace numerics;

void HeldTool::list_fields(Fields& io) {
  io.choice("tool", tool, {"down", "eq27"}, "how the tool is held: straight down, or as Eq. 27 prints it (horizontal)");
  io.number("tool_roll_deg", roll, degree, {-360, 360}, "turns it about its own axis");
  io.number("tool_yaw_deg", yaw, degree, {-360, 360}, "then turns it about the vertical");
}

Eigen::Matrix3d HeldTool::rotation() const {
  Eigen::Matrix3d R = experiments::rotation(tool);
  if (roll != 0) R = R * robots::rotation_from_rpy({0, 0, roll});
  if (yaw != 0) R = robots::rotation_from_rpy({0, 0, yaw}) * R;
  return R;
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

void list_spacing(Fields& io, Spacing& spacing) {
  io.choice("spacing", spacing, {"k_over_n", "k_over_n_minus_1"},
            "point k = 0 ... n - 1 lies at this fraction of the path");
}

double fraction_at(int k, int points, Spacing spacing) {
  const int intervals = spacing == Spacing::k_over_n ? points : std::max(points - 1, 1);
  return static_cast<double>(k) / intervals;
}

std::vector<double> by_rows(const Eigen::Matrix3d& R) {
  std::vector<double> elements;
  for (int row = 0; row < 3; ++row) elements.insert(elements.end(), {R(row, 0), R(row, 1), R(row, 2)});
  return elements;
}

}  // namespace ikbench::experiments
