// Rotations of a tool, as study files and stores write them, and common parts of paths.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "numerics/fields.hpp"

namespace ikbench::experiments {

// The tool's orientation along a path. down: R = diag(-1, 1, -1). eq27: its third column is (0, 1, 0), a horizontal
// tool, as Eq. 27 prints; its other columns are our choice.
enum class Tool { down, eq27 };

Eigen::Matrix3d rotation(Tool tool);

// A tool that is turned about its own axis, and then about the vertical.
struct HeldTool {
  Tool tool = Tool::down;
  double roll = 0, yaw = 0;  // [rad]

  void list_fields(numerics::Fields& io);
  Eigen::Matrix3d rotation() const;
};

// Point k of n, k = 0 ... n - 1, lies at the fraction k/n or k/(n - 1) of the path.
enum class Spacing { k_over_n, k_over_n_minus_1 };

void list_spacing(numerics::Fields& io, Spacing& spacing);
double fraction_at(int k, int points, Spacing spacing);

// The nine elements of a rotation, row by row.
std::vector<double> by_rows(const Eigen::Matrix3d& R);

}  // namespace ikbench::experiments
