// What is left to go and its slope as KDL, the Robotics Toolbox and their sources have them: metres and radians side by
// side, whatever a radian weighs in the error that is to be reduced.
#pragma once

#include "solvers/objective.hpp"

namespace ikbench::solvers {

// As Objective::linearize, but the rows of a rotation are in radians.
inline Residual linearize_twist(Objective& objective, const robots::ConfigurationRef& q, Eigen::MatrixXd& jacobian) {
  Residual to_go = objective.linearize(q, jacobian);
  if (objective.rows() == 3) return to_go;
  to_go.tail<3>() /= objective.goal().rotation_weight;
  jacobian.bottomRows<3>() /= objective.goal().rotation_weight;
  return to_go;
}

}  // namespace ikbench::solvers
