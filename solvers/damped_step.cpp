#include "solvers/damped_step.hpp"

#include <Eigen/Cholesky>

namespace ikbench::solvers {

namespace {

// Computes the step as J^T (J J^T + mu I)^-1 e, whose size does not depend on the number of joints. Sums go from the
// first joint to the last, and over rows in Eigen's order of that size, a constant.
template <int rows>
void step_of_rows(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step) {
  Eigen::Matrix<double, rows, rows> damped;  // its lower half
  for (Eigen::Index joint = 0; joint < jacobian.cols(); ++joint) {
    const double* const column = &jacobian(0, joint);
    for (int c = 0; c < rows; ++c) {
      for (int r = c; r < rows; ++r) {
        const double product = column[r] * column[c];
        damped(r, c) = joint == 0 ? product : damped(r, c) + product;
      }
    }
  }
  damped.diagonal().array() += mu;
  const Eigen::Matrix<double, rows, 1> solution = damped.ldlt().solve(to_go.head<rows>());
  step.resize(jacobian.cols());
  for (Eigen::Index joint = 0; joint < jacobian.cols(); ++joint)
    step[joint] = jacobian.col(joint).head<rows>().dot(solution);
}

}  // namespace

void damped_step(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step) {
  if (jacobian.rows() == 3) {
    step_of_rows<3>(jacobian, to_go, mu, step);
  } else {
    step_of_rows<6>(jacobian, to_go, mu, step);
  }
}

}  // namespace ikbench::solvers
