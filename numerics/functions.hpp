// Elementary functions for everything that decides a number: sine, cosine, arc tangent, exponential and whole power.
// Those of C libraries differ in their last bits between libraries and processors; these use only + - * / and fused
// multiply-add.
#pragma once

#include <Eigen/Core>

namespace ikbench::numerics {

struct SinCos {
  double sine, cosine;
};

// Within 1.5 ulp and 1.6e-33 per quarter turn; NaN if the angle is infinite, NaN or 2^51 quarter turns (3.5e15 rad) or
// more.
SinCos sin_cos(double angle);
// The same for many angles, with as many sines and cosines.
void sines_and_cosines(const Eigen::Ref<const Eigen::VectorXd>& angles, Eigen::Ref<Eigen::VectorXd> sines,
                       Eigen::Ref<Eigen::VectorXd> cosines);
// The angle of (x, y) in [-pi, pi], within 3 ulp; 0 for (0, 0).
double arc_tangent(double y, double x);
// e to the power of x, within 1 ulp; infinity above 709.78, 0 below -708.39.
double exponential(double x);
// x to the power of n >= 0, by multiplication.
double power(double x, int n);
// The product of two vectors, added up as other sums of Eigen are: its own dot() has another order from version 5 on.
template <class A, class B>
double dot(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return a.cwiseProduct(b).sum();
}

}  // namespace ikbench::numerics
