// The step that damped least squares and Levenberg and Marquardt's method have alike.
#pragma once

#include "solvers/objective.hpp"

namespace ikbench::solvers {

// (J^T J + mu I)^-1 J^T e into `step` [rad, m], of a Jacobian with 3 rows (a position) or 6 (a pose).
void damped_step(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step);

}  // namespace ikbench::solvers
