// An arm by name: its kinematics and its joint limits.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robots/chain.hpp"

namespace ikbench::robots {

struct JointLimits {
  Configuration lower, upper;  // [rad], Eq. 4

  // How far the worst joint is outside [rad]; 0 inside.
  double violation(const ConfigurationRef& q) const;
};

struct Robot {
  std::string name;
  std::string summary;
  std::shared_ptr<const Kinematics> kinematics;
  JointLimits limits;

  int joints() const { return kinematics->joints(); }
  // Null where the arm is no Denavit-Hartenberg chain.
  const Chain* chain() const { return dynamic_cast<const Chain*>(kinematics.get()); }
};

std::vector<Robot> all_robots();
// std::invalid_argument names those there are.
Robot robot(std::string_view name);

}  // namespace ikbench::robots
