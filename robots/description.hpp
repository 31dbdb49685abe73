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
};

// The joints from the base to the tool; the last frame is the tool's.
using Description = std::vector<DescribedJoint>;

// Of the joints that move.
std::vector<std::string> joint_names(const Description& description);

// A pose as a Frame. Numbers within 1e-14 of 0 or of a multiple of 15 degrees become exact.
Frame frame_of(const Pose& pose);

// T_base_tool by the product of origins and of rotations about the axes; `q` has only the joints that move.
Pose pose_of(const Description& description, const ConfigurationRef& q);

// The same arm, but for rounding: to 1e-12 m and rad for an arm of a few metres, also if axes are almost parallel.
// Throws std::invalid_argument if no joint or more than 64 joints move.
Chain chain_of(const Description& description);

}  // namespace ikbench::robots
