// The pseudo-inverse of a Jacobian.
#pragma once

#include <cmath>

#include "solvers/objective.hpp"

namespace ikbench::solvers {

// J^+ r, without singular values below `smallest`. Rotations of pairs of its rows, which do not change J^+ r, make them
// orthogonal; their lengths are then the singular values (one-sided Jacobi, Hestenes 1958).
template <int rows>
robots::Configuration pseudo_inverse_times(const Eigen::MatrixXd& jacobian, const Residual& residual, double smallest) {
  Eigen::Matrix<double, Eigen::Dynamic, rows, 0, robots::most_joints, rows> J = jacobian.topRows<rows>().transpose();
  Eigen::Matrix<double, rows, 1> r = residual.head<rows>();
  constexpr int most_sweeps = 30;
  bool turned = true;
  for (int sweep = 0; sweep < most_sweeps && turned; ++sweep) {
    turned = false;
    for (int i = 0; i < rows; ++i) {
      for (int k = i + 1; k < rows; ++k) {
        const double ii = J.col(i).squaredNorm(), kk = J.col(k).squaredNorm(), ik = J.col(i).dot(J.col(k));
        if (!(std::abs(ik) > 1e-15 * std::sqrt(ii * kk))) continue;
        turned = true;
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
      }
    }
  }
  robots::Configuration product = robots::Configuration::Zero(J.rows());
  for (int i = 0; i < rows; ++i) {
    const double squared = J.col(i).squaredNorm();
    if (squared > 0 && !(squared < smallest * smallest)) product += r[i] / squared * J.col(i);
  }
  return product;
}

// The same for a Jacobian with 3 rows (a position) or 6 (a pose).
inline robots::Configuration pseudo_inverse_times(const Eigen::MatrixXd& jacobian, const Residual& residual,
                                                  double smallest) {
  return jacobian.rows() == 3 ? pseudo_inverse_times<3>(jacobian, residual, smallest)
                              : pseudo_inverse_times<6>(jacobian, residual, smallest);
}

}  // namespace ikbench::solvers
