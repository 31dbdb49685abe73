// An arm as in a robot description: joints with an origin and an axis each, in any direction. And the chain in
// Denavit-Hartenberg form that is the same arm.
#pragma once

#include <string>
#include <vector>

#include "base/units.hpp"
#include "robots/chain.hpp"

namespace ikbench::robots {

struct DescribedJoint {
  enum class Motion { none, turns, slides };

  std::string name;
  Motion motion = Motion::none;
  Frame origin;                                     // of the joint, in the frame of the previous joint
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // in its own frame, of length 1
  // What the last printed digit of the origin's angles and of the axis stands for; 0: they are exact.
  Eigen::Vector3d rpy_digits = Eigen::Vector3d::Zero(), axis_digits = Eigen::Vector3d::Zero();
};

// The joints from the base to the tool; the last frame is the tool's.
using Description = std::vector<DescribedJoint>;

// Of the joints that move.
std::vector<std::string> joint_names(const Description& description);

// A pose as a Frame. Numbers within 1e-12 of 0 or of a multiple of 15 degrees become exact.
Frame frame_of(const Pose& pose);

// T_base_tool by the product of origins and of rotations about the axes; `q` has only the joints that move.
Pose pose_of(const Description& description, const ConfigurationRef& q);

// The same arm to 1e-9 m and rad, with no length beyond longest_m. Throws std::invalid_argument if there is none (axes
// almost parallel), or if no joint or more than 64 joints move.
constexpr double longest_m = 1e6;
Chain chain_of(const Description& description);

// Makes angles within `within` [rad] of multiples of 15 degrees exact, and axes that are so near to those of a frame or
// to parallel: files print 1.5708 for a quarter turn. Up to least_snap only what the printed digits may mean: 1.5e-05
// is a calibration. Returns the name of the joint of each change.
constexpr double least_snap = 0.001 * base::degree;
std::vector<std::string> snap(Description& description, double within);

}  // namespace ikbench::robots
