// The step of damped least squares and of Levenberg and Marquardt's method.
#pragma once

#include "solvers/objective.hpp"

namespace ikbench::solvers {

// Writes (J^T J + mu I)^-1 J^T e into `step` [rad, m]. J has 3 rows (a position) or 6 (a pose).
void damped_step(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step);

}  // namespace ikbench::solvers
