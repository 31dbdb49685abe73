// An arm by name: its chain and its joint limits.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robots/chain.hpp"

namespace ikbench {

struct JointLimits {
  Configuration lower, upper;  // [rad], Eq. 4

  // How far the worst joint is outside [rad]; 0 inside.
  double violation(const ConfigurationRef& q) const;
};

struct Robot {
  std::string name;
  std::string summary;
  Chain chain;
  JointLimits limits;
};

std::vector<Robot> robots();
// std::invalid_argument names those there are.
Robot robot(std::string_view name);

}  // namespace ikbench
