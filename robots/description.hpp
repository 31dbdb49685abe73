// An arm as a robot description has it: joints with an origin and an axis each, in any direction; and the chain that is
// the same arm in Denavit-Hartenberg form.
#pragma once

#include <string>
#include <vector>

#include "robots/chain.hpp"

namespace ikbench::robots {

struct DescribedJoint {
  enum class Motion { none, turns, slides };

  std::string name;
  Motion motion = Motion::none;
  Frame origin;                                     // of the joint, in the frame of the joint before it
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // in its own frame, of length 1
};

// From the base to the tool; the tool's frame is that of the last of them.
using Description = std::vector<DescribedJoint>;

// A pose in numbers, those within 1e-12 of 0 and of multiples of 15 degrees exact.
Frame frame_of(const Pose& pose);

// T_base_tool by the product of origins and of rotations about the axes; `q` has the joints that move.
Pose pose_of(const Description& description, const ConfigurationRef& q);

// The same arm to 1e-9 m and rad; std::invalid_argument where there is none, for axes that are all but parallel, or
// more than 64 joints move, or none.
Chain chain_of(const Description& description);

// Angles that are meant to be multiples of 15 degrees, and axes that are meant to be those of a frame or parallel, made
// so where they are nearer than `within` [rad]: files print 1.5708 for a quarter turn. How many there were.
int snap(Description& description, double within);

}  // namespace ikbench::robots
