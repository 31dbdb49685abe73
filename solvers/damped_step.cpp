#include "solvers/damped_step.hpp"

#include <Eigen/Cholesky>

namespace ikbench::solvers {

namespace {

// Computes the step as J^T (J J^T + mu I)^-1 e, whose size does not depend on the number of joints. `rows` is a
// constant, so that sums over rows have one order.
template <int rows>
void step_of_rows(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step) {
  const auto J = jacobian.topRows<rows>();
  using Square = Eigen::Matrix<double, rows, rows>;
  const Square damped = J.lazyProduct(J.transpose()) + mu * Square::Identity();
  step.noalias() = J.transpose() * damped.ldlt().solve(to_go.head<rows>());
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
