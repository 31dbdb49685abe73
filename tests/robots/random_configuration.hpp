// Random configurations for the tests of robots, which know nothing of the solvers' random streams.
#pragma once

#include "base/inputs.hpp"
#include "base/units.hpp"
#include "numerics/functions.hpp"
#include "robots/robot.hpp"
#include "robots/rotation.hpp"
#include "robots/spherical_wrist.hpp"
#include "robots/urdf.hpp"
#include "tests/common.hpp"
#include "tests/numerics/reference.hpp"

using namespace ikbench::base;
using namespace ikbench::numerics;
using namespace ikbench::robots;

namespace ikbench {

struct RandomConfigurations : Dice {
  // Uniform within the limits, or within half a turn each way of 0 without limits.
  Eigen::VectorXd operator()(const robots::JointLimits& all) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(all.lower.size());
    const robots::JointLimits limits = all.around(q);
    for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = between(limits.lower[j], limits.upper[j]);
    return q;
  }
};

}  // namespace ikbench
