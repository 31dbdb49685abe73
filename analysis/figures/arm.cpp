#include "analysis/figures/arm.hpp"

#include <algorithm>

namespace ikbench::figures {

using namespace robots;

std::vector<Point> arm_points(const Robot& arm, const Eigen::VectorXd& q) {
  std::vector<Point> points{{0, 0, 0}};
  const auto add = [&](const Eigen::Vector3d& at) { points.push_back({at.x(), at.y(), at.z()}); };
  robots::Description joints;  // up to the corner
  for (const DescribedJoint& joint : arm.description) {
    joints.push_back(joint);
    add(pose_of(joints, q).translation());
  }
  if (joints.empty()) {
    add(arm.chain.base().position);
    std::vector<DhLink> links;
    for (const DhLink& link : arm.chain.links()) {
      links.push_back(link);
      for (const double along_x : {0.0, link.a}) {
        links.back().a = along_x;
        add(Chain(links, arm.chain.base(), {}).position(q.head(static_cast<Eigen::Index>(links.size()))));
      }
    }
    add(arm.chain.position(q));
  }
  points.erase(std::unique(points.begin(), points.end()), points.end());  // a length of 0 is no corner
  return points;
}

}  // namespace ikbench::figures
