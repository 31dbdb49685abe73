#include "robots/reach.hpp"

#include <cmath>

namespace ikbench::robots {

namespace {

// Each sliding joint is held in the middle of its range. Moving it from there moves the tool at most half the range.
struct HeldSlides {
  Chain arm;
  double added = 0;  // [m] sum of the halves; infinite if a sliding joint has no limits
};

HeldSlides hold_slides(const Chain& arm, const JointLimits& limits) {
  std::vector<DhLink> links = arm.links();
  double added = 0;
  for (std::size_t j = 0; j < links.size(); ++j) {
    if (links[j].joint != Joint::slides) continue;
    const double lower = limits.lower[static_cast<Eigen::Index>(j)], upper = limits.upper[static_cast<Eigen::Index>(j)];
    links[j].joint = Joint::turns;
    added += (upper - lower) / 2;
    if (!is_endless(lower, upper)) links[j].d += (lower + upper) / 2;
  }
  return {.arm = Chain(links, arm.base(), arm.tool()), .added = added};
}

}  // namespace

Chain::Ball reach_within(const Chain& arm, const JointLimits& limits) {
  const HeldSlides held = hold_slides(arm, limits);
  Chain::Ball ball = held.arm.reach();
  ball.radius += held.added;
  return ball;
}

double LastAxis::beyond(const Pose& tool) const { return (tool * in_tool - ball.centre).norm() - ball.radius; }

double LastAxis::beyond_of_axis(const Pose& tool) const {
  // The point is on a circle about the tool's z axis. Its nearest place to the ball's centre is in their common plane.
  const Eigen::Vector3d centre = tool.inverse() * ball.centre;
  const double along = centre.z() - in_tool.z(), beside = centre.head<2>().norm() - in_tool.head<2>().norm();
  return std::sqrt(along * along + beside * beside) - ball.radius;
}

std::optional<LastAxis> last_axis_of(const Robot& arm) {
  const std::vector<DhLink>& links = arm.chain.links();
  if (links.size() < 2 || links.back().joint != Joint::turns) return std::nullopt;
  // The frame before the last joint is on its axis, where the axis before is nearest.
  const Chain last({links.back()}, Frame(), arm.chain.tool());
  const HeldSlides before = hold_slides({{links.begin(), links.end() - 1}, arm.chain.base(), Frame()}, arm.limits);
  LastAxis axis{.in_tool = last.forward(Configuration::Zero(1)).inverse().translation(),
                .ball = before.arm.smallest_ball()};
  axis.ball.radius += before.added;
  return axis;
}

}  // namespace ikbench::robots
