#include "solvers/damped_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "numerics/functions.hpp"

namespace ikbench::solvers {

using numerics::dot;

namespace {

// Solves (M M^T + mu I) x = b in place, and returns what damped_step does. The factors L D L^T are those of Eigen's
// LDLT, bit for bit, with the larger diagonals first; but its loops do not know their length.
template <class Matrix, int rows = Matrix::RowsAtCompileTime>
double solve_damped(const Matrix& M, double mu, Eigen::Matrix<double, rows, 1>& x) {
  using Column = Eigen::Matrix<double, rows, 1>;
  Column diagonal = Column::Zero();
  for (Eigen::Index k = 0; k < M.cols(); ++k) diagonal += M.col(k).cwiseAbs2();
  diagonal.array() += mu;
  std::array<Eigen::Index, rows> order;
  std::iota(order.begin(), order.end(), 0);
  const auto is_less = [&](Eigen::Index a, Eigen::Index b) { return diagonal[a] < diagonal[b]; };
  for (auto next = order.begin(); next != order.end(); ++next)
    std::iter_swap(next, std::max_element(next, order.end(), is_less));

  Eigen::Matrix<double, rows, rows> LD = Eigen::Matrix<double, rows, rows>::Zero();  // D is on the diagonal
  for (Eigen::Index c = 0; c < M.cols(); ++c) {
    const Column column = M.col(c)(order);
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
  Column solution = x(order);
  LD.template triangularView<Eigen::UnitLower>().solveInPlace(solution);
  for (int k = 0; k < rows; ++k)
    solution[k] = std::abs(LD(k, k)) > std::numeric_limits<double>::min() ? solution[k] / LD(k, k) : 0;
  LD.transpose().template triangularView<Eigen::UnitUpper>().solveInPlace(solution);
  x(order) = solution;

  // A lower bound: the determinant, divided by an upper bound of the product of the other eigenvalues.
  const double sum = diagonal.sum();
  double smallest = LD(0, 0);
  for (int k = 1; k < rows; ++k) smallest *= (rows - 1) * LD(k, k) / sum;
  return smallest > 1e-8 * sum ? smallest : 0;
}

// Computes J^T (J J^T + mu I)^-1 e, whose factored matrix does not grow with the number of joints.
template <int rows>
double step_of_rows(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step) {
  const auto J = jacobian.topRows<rows>();
  Eigen::Matrix<double, rows, 1> x = to_go.head<rows>();
  const double smallest = solve_damped(J, mu, x);
  step.resize(J.cols());
  for (Eigen::Index joint = 0; joint < J.cols(); ++joint) step[joint] = dot(J.col(joint), x);
  return smallest;
}

// Computes (J^T J + mu I)^-1 J^T e, for fewer joints than rows, where J J^T has no inverse.
template <int joints>
double step_of_joints(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step) {
  const auto transposed = jacobian.transpose().topRows<joints>();
  Eigen::Matrix<double, joints, 1> x = Eigen::Matrix<double, joints, 1>::Zero();
  for (Eigen::Index row = 0; row < to_go.size(); ++row) x += to_go[row] * transposed.col(row);
  const double smallest = solve_damped(transposed, mu, x);
  step = x;
  return smallest;
}

// Rotates columns i and k of J, and elements i and k of r, so that the columns become orthogonal. Returns false if
// there is nothing to rotate, or only rounding errors: one of the squared lengths is at most `negligible`.
template <class Columns, class Vector>
bool rotate(Columns& J, Vector& r, std::pair<int, int> pair, double negligible) {
  const auto [i, k] = pair;
  const double ii = J.col(i).squaredNorm(), kk = J.col(k).squaredNorm(), ik = dot(J.col(i), J.col(k));
  if (!(std::abs(ik) > 1e-15 * std::sqrt(ii * kk))) return false;
  const double cotangent = (kk - ii) / (2 * ik);  // of twice the angle
  const double tangent = (cotangent < 0 ? -1 : 1) / (std::abs(cotangent) + std::sqrt(1 + cotangent * cotangent));
  const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
  const auto turn = [&](double& a, double& b) {
    const double before = a;
    a = cosine * a - sine * b;
    b = sine * before + cosine * b;
  };
  for (Eigen::Index j = 0; j < J.rows(); ++j) turn(J(j, i), J(j, k));
  turn(r[i], r[k]);
  return std::min(ii, kk) > negligible;
}

// Computes J^+ r. Rotations of pairs of J's rows, which do not change J^+ r, make the rows orthogonal. Their lengths
// are then the singular values (one-sided Jacobi, Hestenes 1958). A row of rounding errors alone never becomes
// orthogonal, so the sweeps do not wait for it, and it counts as zero.
template <int rows>
robots::Configuration pseudo_inverse_of_rows(const Eigen::MatrixXd& jacobian, const Residual& residual,
                                             double smallest) {
  Eigen::Matrix<double, Eigen::Dynamic, rows, 0, robots::max_joints, rows> J = jacobian.topRows<rows>().transpose();
  Eigen::Matrix<double, rows, 1> r = residual.head<rows>();
  const double negligible = 1e-28 * J.squaredNorm();
  constexpr int max_sweeps = 30;
  bool turned = true;
  for (int sweep = 0; sweep < max_sweeps && turned; ++sweep) {
    turned = false;
    for (int i = 0; i < rows; ++i) {
      for (int k = i + 1; k < rows; ++k) turned = rotate(J, r, {i, k}, negligible) || turned;
    }
  }
  robots::Configuration product = robots::Configuration::Zero(J.rows());
  for (int i = 0; i < rows; ++i) {
    const double squared = J.col(i).squaredNorm();
    if (squared > negligible && !(squared < smallest * smallest)) product += r[i] / squared * J.col(i);
  }
  return product;
}

}  // namespace

double damped_step(const Eigen::MatrixXd& jacobian, const Residual& to_go, double mu, robots::Configuration& step) {
  if (jacobian.cols() >= jacobian.rows())
    return jacobian.rows() == 3 ? step_of_rows<3>(jacobian, to_go, mu, step)
                                : step_of_rows<6>(jacobian, to_go, mu, step);
  constexpr std::array step_of = {step_of_joints<1>, step_of_joints<2>, step_of_joints<3>, step_of_joints<4>,
                                  step_of_joints<5>};
  return step_of[static_cast<std::size_t>(jacobian.cols() - 1)](jacobian, to_go, mu, step);
}

robots::Configuration pseudo_inverse_times(const Eigen::MatrixXd& jacobian, const Residual& residual, double smallest) {
  return jacobian.rows() == 3 ? pseudo_inverse_of_rows<3>(jacobian, residual, smallest)
                              : pseudo_inverse_of_rows<6>(jacobian, residual, smallest);
}

}  // namespace ikbench::solvers
