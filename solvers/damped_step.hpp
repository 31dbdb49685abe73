// Parts of the textbook solvers: the Jacobian in the units of their sources, and the steps of damped least squares, of
// Levenberg and Marquardt's method and of Newton's method.
#pragma once

#include "solvers/objective.hpp"

namespace ikbench::solvers {

// Writes (J^T J + mu I)^-1 J^T e into `step` [rad, m]. J has 3 rows (a position) or 6 (a pose). Returns a lower bound
// of the eigenvalues of J J^T + mu I, or of J^T J + mu I if there are fewer joints than rows. Returns 0 if the bound is
// below 1e-8 of their sum, where the step may have lost eight digits.
double damped_step(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step);

// Returns J^+ r without singular values below `smallest`. J has 3 rows or 6.
robots::Configuration pseudo_inverse_times(const Eigen::MatrixXd& jacobian, const Residual& residual, double smallest);

// Does what Objective::linearize does, but with the rows of a rotation in radians, beside metres as in KDL and the
// Robotics Toolbox, whatever the weight of a radian in the error.
inline Linearized linearize_twist(Objective& objective, const robots::ConfigurationRef& q, Eigen::MatrixXd& jacobian) {
  Linearized linearized = objective.linearize(q, jacobian);
  if (objective.rows() == 3) return linearized;
  linearized.to_go.tail<3>() /= objective.goal().rotation_weight;
  jacobian.bottomRows<3>() /= objective.goal().rotation_weight;
  return linearized;
}

}  // namespace ikbench::solvers
