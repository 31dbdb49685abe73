#include "analysis/figures/arm.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robots/robot.hpp"

namespace ikbench::figures {

using namespace inference;
using namespace robots;

std::vector<Point> arm_points(const StudyFacts& facts, const std::vector<double>& angles_rad) {
  const std::optional<Robot> arm = stored_arm(facts.json);
  const Eigen::Map<const Eigen::VectorXd> q(angles_rad.data(), static_cast<Eigen::Index>(angles_rad.size()));
  if (!arm || q.size() != arm->joints() || !q.allFinite()) return {};
  std::vector<Point> points{{0, 0, 0}};
  std::vector<DhLink> links;  // up to the corner
  const auto add_corner = [&](const Frame& tool) {
    const Chain chain(links, arm->chain.base(), tool);
    const Eigen::Vector3d at = chain.position(q.head(chain.joints()));
    points.push_back({at.x(), at.y(), at.z()});
  };
  add_corner({});
  for (const DhLink& link : arm->chain.links()) {
    links.push_back(link);
    links.back().a = 0;  // the corner between the lengths along z and x
    add_corner({});
    links.back().a = link.a;
    add_corner({});
  }
  add_corner(arm->chain.tool());
  points.erase(std::unique(points.begin(), points.end()), points.end());  // a length of 0 is no corner
  return points;
}

}  // namespace ikbench::figures
