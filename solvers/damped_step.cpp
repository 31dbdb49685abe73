#include "solvers/damped_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ikbench::solvers {

namespace {

// Computes the step as J^T (J J^T + mu I)^-1 e, whose size does not depend on the number of joints. The factors L D L^T
// are those of Eigen's LDLT, bit for bit, with the larger diagonals first; but its loops do not know their length.
template <int rows>
double step_of_rows(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step) {
  using Column = Eigen::Matrix<double, rows, 1>;
  Column diagonal = Column::Zero();
  for (Eigen::Index joint = 0; joint < jacobian.cols(); ++joint)
    diagonal += jacobian.col(joint).head<rows>().cwiseAbs2();
  diagonal.array() += mu;
  std::array<Eigen::Index, rows> order;
  std::iota(order.begin(), order.end(), 0);
  const auto is_less = [&](Eigen::Index a, Eigen::Index b) { return diagonal[a] < diagonal[b]; };
  for (auto next = order.begin(); next != order.end(); ++next)
    std::iter_swap(next, std::max_element(next, order.end(), is_less));

  Eigen::Matrix<double, rows, rows> LD = Eigen::Matrix<double, rows, rows>::Zero();  // D is on the diagonal
  for (Eigen::Index joint = 0; joint < jacobian.cols(); ++joint) {
    const Column column = jacobian.col(joint)(order);
#pragma GCC unroll 6
    for (int k = 0; k < rows; ++k) {
#pragma GCC unroll 6
      for (int r = k + 1; r < rows; ++r) LD(r, k) += column[r] * column[k];
    }
  }
  LD.diagonal() = diagonal(order);
#pragma GCC unroll 6
  for (int k = 0; k < rows; ++k) {
#pragma GCC unroll 6
    for (int r = k; r < rows; ++r) {
      double sum = 0;
#pragma GCC unroll 6
      for (int j = 0; j < k; ++j) sum += LD(r, j) * (LD(j, j) * LD(k, j));
      LD(r, k) -= sum;
      if (r > k && LD(k, k) != 0) LD(r, k) /= LD(k, k);
    }
  }
  Column solution = to_go(order);
  LD.template triangularView<Eigen::UnitLower>().solveInPlace(solution);
  for (int k = 0; k < rows; ++k)
    solution[k] = std::abs(LD(k, k)) > std::numeric_limits<double>::min() ? solution[k] / LD(k, k) : 0;
  LD.transpose().template triangularView<Eigen::UnitUpper>().solveInPlace(solution);
  Column in_order;
  in_order(order) = solution;
  step.resize(jacobian.cols());
  for (Eigen::Index joint = 0; joint < jacobian.cols(); ++joint)
    step[joint] = jacobian.col(joint).head<rows>().dot(in_order);

  // The determinant over what the larger eigenvalues are at most together.
  const double sum = diagonal.sum();
  double smallest = LD(0, 0);
  for (int k = 1; k < rows; ++k) smallest *= (rows - 1) * LD(k, k) / sum;
  return smallest > 1e-8 * sum ? smallest : 0;
}

}  // namespace

double damped_step(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step) {
  return jacobian.rows() == 3 ? step_of_rows<3>(jacobian, to_go, mu, step) : step_of_rows<6>(jacobian, to_go, mu, step);
}

}  // namespace ikbench::solvers
