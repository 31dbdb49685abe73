// Robot descriptions, as URDF files have them: joints with an origin and an axis each, in any direction. `chain_of`
// makes the chain in Denavit-Hartenberg form, by which every solver computes.
#pragma once

#include <string>
#include <vector>

#include "base/units.hpp"
#include "robots/chain.hpp"

namespace ikbench::robots {

// A joint of a description.
struct DescribedJoint {
  enum class Motion { none, turns, slides };  // fixed; revolute or continuous; prismatic

  std::string name;
  Motion motion = Motion::none;
  Frame origin;                                     // the joint's frame, in that of the previous joint
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // in the joint's frame, of length 1
};

// The joints from the base to the tool; the last frame is the tool's.
using Description = std::vector<DescribedJoint>;

// Returns the names of the joints that move.
std::vector<std::string> joint_names(const Description& description);

// Returns a pose as a Frame. Numbers within 1e-14 of 0 or of a multiple of 15 degrees become exact.
Frame frame_of(const Pose& pose);

// Returns T_base_tool, as the product of origins and of motions about or along the axes. `q` has only the joints that
// move [rad, m].
Pose pose_of(const Description& description, const ConfigurationRef& q);

// Returns the arm of a description as a chain. Its poses differ by rounding only: by 1e-12 m and rad for an arm of a
// few metres, also if axes are almost parallel. Throws std::invalid_argument if no joint or more than 64 joints move.
Chain chain_of(const Description& description);

}  // namespace ikbench::robots
