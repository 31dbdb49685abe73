// Rotations of a tool, as study files and stores write them, and common parts of paths.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/fields.hpp"

namespace ikbench::experiments {

// The tool's orientation along a path. down: R = diag(-1, 1, -1). eq27: its third column is (0, 1, 0), a horizontal
// tool, as Eq. 27 prints; its other columns are our choice.
enum class Tool { down, eq27 };

void list_tool(Fields& io, Tool& tool);
Eigen::Matrix3d rotation(Tool tool);

// Point k of n, k = 0 ... n - 1, lies at the fraction k/n or k/(n - 1) of the path.
enum class Spacing { k_over_n, k_over_n_minus_1 };

void list_spacing(Fields& io, Spacing& spacing);

// The plane of a flat path, spanned by the first axis and the second.
enum class Plane { xy, xz, yz };

void list_plane(Fields& io, Plane& plane);
Eigen::Vector3d along(Plane plane, double first, double second);
Eigen::Vector3d normal(Plane plane);  // first x second

// Targets at the fractions k/(n - 1), k = 0 ... n - 1, of a path, so at both ends too. `point_at(fraction)` gives the
// tool's position.
template <class PointAt>
std::vector<robots::Pose> poses_along(int points, Tool tool, PointAt point_at) {
  std::vector<robots::Pose> poses;
  for (int k = 0; k < points; ++k) {
    robots::Pose pose = robots::Pose::Identity();
    pose.linear() = rotation(tool);
    pose.translation() = point_at(static_cast<double>(k) / (points > 1 ? points - 1 : 1));
    poses.push_back(pose);
  }
  return poses;
}

// The nine elements of a rotation, row by row.
std::vector<double> by_rows(const Eigen::Matrix3d& R);

}  // namespace ikbench::experiments
