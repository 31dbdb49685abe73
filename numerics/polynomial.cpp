#include "numerics/polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace ikbench::numerics {

namespace {

// A value below this share of the sum of its terms' sizes counts as rounding.
constexpr double rounding = 1e-14;

struct Value {
  double value, slope;
  int sign;  // 0 if the value is rounding
};

Value at(const Polynomial& p, double x) {
  double value = 0, slope = 0, size = 0;
  for (Eigen::Index i = p.size(); i-- > 0;) {
    slope = slope * x + value;
    value = value * x + p[i];
    size = size * std::abs(x) + std::abs(p[i]);
  }
  return {value, slope, std::abs(value) <= rounding * size ? 0 : value > 0 ? 1 : -1};
}

// Newton's method, which halves the interval if a step leaves it. The signs at the ends must differ.
double root_between(const Polynomial& p, double lower, double upper, int sign_of_lower) {
  double x = 0.5 * (lower + upper);
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Value here = at(p, x);
    if (here.value == 0) break;
    ((here.value > 0) == (sign_of_lower > 0) ? lower : upper) = x;
    double next = x - here.value / here.slope;
    if (!(next > lower && next < upper)) next = 0.5 * (lower + upper);
    if (next == x || next == lower || next == upper) break;
    x = next;
  }
  return x;
}

}  // namespace

Roots real_roots(const Polynomial& polynomial) {
  const Eigen::Index degree = polynomial.size() - 1;
  Roots roots(0);
  const auto add = [&](double root) {
    roots.conservativeResize(roots.size() + 1);
    roots[roots.size() - 1] = root;
  };
  if (degree < 1) return roots;
  if (degree == 1) {
    add(-polynomial[0] / polynomial[1]);
    return roots;
  }
  // The polynomial is monotonic between the roots of its derivative, and beyond them to twice Cauchy's bound of all
  // roots.
  Polynomial derivative(degree);
  for (Eigen::Index i = 0; i < degree; ++i) derivative[i] = static_cast<double>(i + 1) * polynomial[i + 1];
  const Roots turns = real_roots(derivative);
  const double bound = 2 + 2 * polynomial.head(degree).cwiseAbs().maxCoeff() / std::abs(polynomial[degree]);
  double lower = -bound;
  int sign_of_lower = at(polynomial, lower).sign;
  for (Eigen::Index i = 0; i <= turns.size(); ++i) {
    const double upper = i < turns.size() ? turns[i] : bound;
    const int sign = at(polynomial, upper).sign;
    if (sign * sign_of_lower < 0) add(root_between(polynomial, lower, upper, sign_of_lower));
    if (sign == 0 && i < turns.size()) add(upper);
    lower = upper;
    sign_of_lower = sign;
  }
  return roots;
}

}  // namespace ikbench::numerics
