// The spherical wrist (Eqs. 15-17): the last three axes meet in a point. The first joints place that point, and the
// last three angles follow from the orientation in closed form.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "robots/chain.hpp"

namespace ikbench::robots {

// An arm with a spherical wrist, split into the joints before the wrist and the wrist's three joints.
class SphericalWrist {
 public:
  // Returns true if the last three axes meet in a point, each at right angles to the next, to 1e-10 m and rad, and if
  // there are joints before them. Such a chain has twists of 90 or -90 degrees without lengths between these axes, with
  // eleven digits in its file. Frames behind the last axis count as the tool.
  static bool fits(const Chain& whole);
  // Returns "its last three axes are 1.2 mm from a common point and 0.0002 deg from right angles". Empty if the axes
  // fit, or if the last three joints are not revolute joints behind another joint.
  static std::string misfit(const Chain& whole);

  // Throws std::invalid_argument if the chain does not fit.
  explicit SphericalWrist(const Chain& whole);

  // Returns the joints before the wrist, as a chain whose tool point is the wrist's centre.
  const Chain& arm() const { return arm_; }

  // Returns the position of the wrist's centre that a pose of the tool requires, Eq. 15.
  Eigen::Vector3d centre(const Pose& T_base_tool) const;

  // Returns the wrist's angles for an orientation, each in [-pi, pi], in both branches: first with the middle angle >=
  // 0, then < 0. If the outer axes coincide (middle angle 0 or pi), only the sum or the difference of their angles is
  // fixed. The first branch then keeps the first angle of `near`, the wrist's present angles.
  std::array<Eigen::Vector3d, 2> angles(const ConfigurationRef& q_arm, const Eigen::Matrix3d& R_base_tool,
                                        const Eigen::Vector3d& near) const;

 private:
  Chain arm_;
  Eigen::Vector3d offsets_;                     // of the three joints
  double sense_;                                // +1 if the middle joint turns about +y, -1 if about -y
  Eigen::Vector3d tool_in_tool_;                // tool point relative to the wrist's centre, in the tool's frame
  std::optional<Eigen::Matrix3d> R_tool_last_;  // set if the tool is turned in the last link's frame
};

}  // namespace ikbench::robots
