// Apart from objectives.hpp, because it is slow to compile.
#pragma once

#include <Eigen/QR>

namespace ikbench {

inline Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& A) {
  return A.completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace ikbench
