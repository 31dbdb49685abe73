// Real roots of polynomials of a low degree.
#pragma once

#include <Eigen/Core>

namespace ikbench::numerics {

constexpr int highest_degree = 4;
using Polynomial =
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, highest_degree + 1, 1>;  // coefficients from the constant
using Roots = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, highest_degree, 1>;

// The real roots, ascending, each once, including roots where the polynomial only touches zero, up to rounding. The
// last coefficient must not be 0, and none so large that the roots or the values between them overflow.
Roots real_roots(const Polynomial& polynomial);

}  // namespace ikbench::numerics
