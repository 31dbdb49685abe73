// The step of damped least squares and of Levenberg and Marquardt's method; undamped, Newton's.
#pragma once

#include "solvers/objective.hpp"

namespace ikbench::solvers {

// Writes (J^T J + mu I)^-1 J^T e into `step` [rad, m]. J has 3 rows (a position) or 6 (a pose). Returns a number that
// no eigenvalue of J J^T + mu I is below, or 0 if it is below 1e-8 of their sum: then the step may have lost eight
// digits.
double damped_step(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step);

}  // namespace ikbench::solvers
