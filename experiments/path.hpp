// Paths: where the tool has to go, as a list of target poses. Metres and radians.
#pragma once

#include <variant>
#include <vector>

#include "robots/robot.hpp"
#include "numerics/random.hpp"

namespace ikbench::experiments {

// How the tool is held along a path: down is R = diag(-1, 1, -1); eq27 has (0, 1, 0) as its third column, a horizontal
// tool, as Eq. 27 prints (its other columns are our choice).
enum class Tool { down, eq27 };
// sin_cos: (x, y) = centre + radius (sin t, cos t); cos_sin: centre + radius (cos t, sin t).
enum class Phase { sin_cos, cos_sin };
// Point k of n, k = 0 ... n - 1, lies at the fraction k/n or k/(n - 1) of the path.
enum class Spacing { k_over_n, k_over_n_minus_1 };

// Slim et al. 2023, Sec. 5.2.
struct Helix {
  Eigen::Vector3d centre{0.60, 0.0, 0.10};  // of the bottom
  double radius = 0.20;
  double length = 0.50;
  double turns = 2;
  double start = 0;  // added to t
  int points = 20;
  Phase phase = Phase::sin_cos;
  Spacing spacing = Spacing::k_over_n;
  Tool tool = Tool::down;
};

// Slim et al. 2023, Sec. 6: level, point k of n at centre + radius (cos t, sin t, 0), t = 2 pi k/n.
struct Circle {
  Eigen::Vector3d centre{0.16, 0.16, 0.0};
  double radius = 0.07;
  int points = 20;
  Tool tool = Tool::down;
};

// Slim et al. 2023, Table 7: tool poses of configurations drawn anew for every run, so that the arm can reach them.
struct RandomTargets {
  int points = 20;
};

using Path = std::variant<Helix, Circle, RandomTargets, std::vector<robots::Pose>>;

int points(const Path& path);
std::vector<robots::Pose> along(const Helix& helix);
std::vector<robots::Pose> along(const Circle& circle);
// Of joint angles that are uniform within the limits.
std::vector<robots::Pose> random_poses(const robots::Robot& arm, int count, numerics::Random& random);
Eigen::Matrix3d rotation(Tool tool);
// The nine elements, row by row.
std::vector<double> by_rows(const Eigen::Matrix3d& R);
// Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy);

}  // namespace ikbench::experiments
