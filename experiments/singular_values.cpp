#include "experiments/singular_values.hpp"

#include <Eigen/SVD>
#include <limits>

namespace ikbench::experiments {

Eigen::VectorXd singular_values(const Jacobian& jacobian) {
  if (!jacobian.allFinite()) return Eigen::VectorXd::Constant(1, std::numeric_limits<double>::quiet_NaN());
  return Eigen::JacobiSVD<Jacobian>(jacobian).singularValues();
}

}  // namespace ikbench::experiments
