// Places that an arm certainly never reaches, so that targets there need no solve. They follow from lengths and limits
// alone, never from samples. A grid of targets leaves them out.
#pragma once

#include <optional>

#include "robots/robot.hpp"

namespace ikbench::robots {

// Returns a ball that the tool's point never leaves while the sliding joints are within their limits. Without sliding
// joints it is Chain::reach(). The radius is infinite if a sliding joint has no limits.
Chain::Ball reach_within(const Chain& arm, const JointLimits& limits);

// A point of the last joint's axis. The last joint does not move it, so the tool's pose fixes its place, and the joints
// before keep it in a ball, which is smaller than that of the tool.
struct LastAxis {
  Eigen::Vector3d in_tool;  // [m] the point, in the tool's frame
  Chain::Ball ball;         // the smallest that is known

  // Returns how far [m] outside the ball the point is in a pose of the tool; negative if it is inside.
  double beyond(const Pose& tool) const;
  // Returns the same for the best turn of the tool about its own z axis, when only the direction of that axis is given.
  double beyond_of_axis(const Pose& tool) const;
};
// Returns the point of the last axis that is nearest to the axis before. Returns nullopt if the arm has one joint, or
// if its last joint does not turn.
std::optional<LastAxis> last_axis_of(const Robot& arm);

}  // namespace ikbench::robots
