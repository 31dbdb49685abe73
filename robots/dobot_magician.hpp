// The Dobot Magician: a small arm whose forearm is held by a parallelogram linkage, so that its angle is that to the
// horizontal whatever the upper arm does. A closed form instead of a chain; the geometry is the one that Table 8 of
// Slim et al. 2023 fixes (docs/paper-notes.md 2.11).
#pragma once

#include "robots/kinematics.hpp"

namespace ikbench::robots {

// Three joints place the tool: the base's turn, the upper arm from the vertical, the forearm below the horizontal. The
// fourth turns the tool about the vertical and moves it nowhere; in Table 8 it is always equal to the first.
class DobotMagician final : public Kinematics {
 public:
  static constexpr double upper_arm = 0.135, forearm = 0.147;  // [m]
  static constexpr double wrist_to_tool = 0.061;               // [m] level, away from the base
  static constexpr double height = 0.058;                      // [m] of the shoulder, less the pen's length

  int joints() const override { return 3; }
  Pose forward(const ConfigurationRef& q) const override;
  Eigen::Vector3d linearize(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const override;
  void position_errors(const CandidatesRef& q, const Eigen::Vector3d& target,
                       Eigen::Ref<Eigen::VectorXd> errors) const override;
  // About the shoulder.
  Ball reach() const override;
  std::string definition() const override;
};

}  // namespace ikbench::robots
