// The residual and Jacobian in the units of KDL, the Robotics Toolbox and their sources: metres and radians side by
// side, whatever the weight of a radian in the error.
#pragma once

#include "solvers/objective.hpp"

namespace ikbench::solvers {

// Like Objective::linearize, but the rows of a rotation are in radians.
inline Linearized linearize_twist(Objective& objective, const robots::ConfigurationRef& q, Eigen::MatrixXd& jacobian) {
  Linearized linearized = objective.linearize(q, jacobian);
  if (objective.rows() == 3) return linearized;
  linearized.to_go.tail<3>() /= objective.goal().rotation_weight;
  jacobian.bottomRows<3>() /= objective.goal().rotation_weight;
  return linearized;
}

}  // namespace ikbench::solvers
