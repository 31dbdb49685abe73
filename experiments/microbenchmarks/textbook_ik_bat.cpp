#include "experiments/microbenchmarks/textbook_ik_bat.hpp"

#include <cmath>
#include <limits>

namespace ikbench::microbenchmarks::textbook {

namespace {

Matrix multiply(const Matrix& a, const Matrix& b) {
  Matrix product(4, Vector(4, 0.0));
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) product[i][j] += a[i][k] * b[k][j];
    }
  }
  return product;
}

Matrix link_transform(const Link& link, double theta) {
  const double c = std::cos(theta), s = std::sin(theta), ca = std::cos(link.alpha), sa = std::sin(link.alpha);
  return {{c, -s * ca, s * sa, link.a * c},  //
          {s, c * ca, -c * sa, link.a * s},  //
          {0, sa, ca, link.d},               //
          {0, 0, 0, 1}};
}

double position_error(const std::vector<Link>& links, const Vector& theta, const Vector& target) {
  const Vector position = forward_kinematics(links, theta);
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::pow(position[k] - target[k], 2);
  return std::sqrt(sum);  // Eq. 1
}

}  // namespace

Vector forward_kinematics(const std::vector<Link>& links, const Vector& theta) {
  Matrix T{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  for (std::size_t j = 0; j < links.size(); ++j) T = multiply(T, link_transform(links[j], theta[j]));
  return {T[0][3], T[1][3], T[2][3]};
}

Result ik_bat(const std::vector<Link>& links, const Vector& target, const Vector& theta_s, const Vector& lower,
              const Vector& upper, int bats, int iterations, std::mt19937_64& generator) {
  constexpr double f_min = 0, f_max = 2, alpha = 0.97, gamma = 0.1, r0 = 1, step_factor = 0.1;
  const std::size_t joints = theta_s.size(), count = static_cast<std::size_t>(bats);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, 1);

  std::vector<Vector> x(count, Vector(joints)), v(count, Vector(joints, 0.0));
  Result best{theta_s, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < joints; ++j) {
      x[i][j] = i == 0 ? theta_s[j] : lower[j] + (upper[j] - lower[j]) * uniform(generator);
    }
    const double error = position_error(links, x[i], target);
    if (error < best.error) best = {x[i], error};
  }

  double loudness = 1;
  for (int t = 0; t < iterations; ++t) {
    loudness *= alpha;                                 // Eq. 9
    const double r = r0 * (1 - std::exp(-gamma * t));  // Eq. 10
    for (std::size_t i = 0; i < count; ++i) {
      const double f = f_min + (f_max - f_min) * uniform(generator);  // Eq. 5
      Vector candidate(joints);
      for (std::size_t j = 0; j < joints; ++j) {
        v[i][j] += (x[i][j] - (best.theta[j] + theta_s[j]) / 2) * f;                                           // Eq. 13
        x[i][j] += v[i][j];                                                                                    // Eq. 7
        candidate[j] = r * best.theta[j] + (1 - r) * theta_s[j] + step_factor * loudness * normal(generator);  // Eq. 14
      }
      const double error = position_error(links, candidate, target);
      if (error < best.error) {
        x[i] = candidate;
        best = {candidate, error};
      }
    }
  }
  return best;
}

}  // namespace ikbench::microbenchmarks::textbook
