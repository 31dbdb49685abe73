// Elementary functions for everything that decides a number: sine, cosine, arc tangent, exponential and whole power.
// Those of C libraries differ in their last bits between libraries and processors; these use only + - * / and fused
// multiply-add.
#pragma once

#include <Eigen/Core>

namespace ikbench::numerics {

struct SinCos {
  double sine, cosine;
};

// Returns sine and cosine within 1.5 ulp and 1.6e-33 per quarter turn. Both are NaN if the angle [rad] is infinite, NaN
// or 2^51 quarter turns (3.5e15 rad) or more.
SinCos sin_cos(double angle);
// Writes the sines and cosines of many angles, with the bits of `sin_cos`. All three vectors have one size.
void sines_and_cosines(const Eigen::Ref<const Eigen::VectorXd>& angles, Eigen::Ref<Eigen::VectorXd> sines,
                       Eigen::Ref<Eigen::VectorXd> cosines);
// Returns the angle of (x, y) in [-pi, pi], within 3 ulp; 0 for (0, 0), NaN if x or y is NaN.
double arc_tangent(double y, double x);
// Returns e to the power of x, within 1 ulp; infinity above 709.78, 0 below -708.39.
double exponential(double x);
// Returns x to the power of n >= 0, by multiplication.
double power(double x, int n);
// Returns the dot product of two vectors, added up in the order of Eigen's sum(). The order of Eigen's own dot() has
// changed with version 5.
template <class A, class B>
double dot(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return a.cwiseProduct(b).sum();
}

}  // namespace ikbench::numerics
