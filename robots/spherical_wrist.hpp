// The spherical wrist (Eqs. 15-17): where the last three axes meet in a point, the first joints place that point and
// the last three angles follow from the orientation in closed form.
#pragma once

#include <array>
#include <optional>

#include "robots/chain.hpp"

namespace ikbench::robots {

class SphericalWrist {
 public:
  // Whether the last three axes meet in a point, each at right angles with the next: twists of -90 and 90 degrees (or
  // 90 and -90) with no lengths between them; and joints are left for the arm. What is behind the last axis is the
  // tool.
  static bool fits(const Chain& whole);

  // std::invalid_argument where it does not fit.
  explicit SphericalWrist(const Chain& whole);

  // The first joints up to the wrist's centre, which is the tool point of this chain.
  const Chain& arm() const { return arm_; }

  // Where the wrist's centre has to be, Eq. 15.
  Eigen::Vector3d centre(const Pose& T_base_tool) const;

  // The last three angles for an orientation, both branches: first with the middle joint's angle >= 0, then < 0;
  // each in [-pi, pi]. Where the outer axes coincide (middle angle 0 or pi) only their sum or difference is fixed: the
  // first answer then keeps the first angle of `near`, the angles the wrist has now.
  std::array<Eigen::Vector3d, 2> angles(const ConfigurationRef& q_arm, const Eigen::Matrix3d& R_base_tool,
                                        const Eigen::Vector3d& near) const;

 private:
  Chain arm_;
  Eigen::Vector3d offsets_;                     // of the three joints
  double sense_;                                // +1 where the middle joint turns about +y, -1 about -y
  Eigen::Vector3d tool_in_tool_;                // tool point from the wrist's centre, in the tool's frame
  std::optional<Eigen::Matrix3d> R_tool_last_;  // where the tool is turned in the last link's frame
};

}  // namespace ikbench::robots
