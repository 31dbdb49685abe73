// IK-BA as an engineer would write it from the paper: vectors of vectors, 4x4 products, the standard library's numbers.
#pragma once

#include <random>
#include <vector>

namespace ikbench::microbenchmarks::textbook {

using Vector = std::vector<double>;
using Matrix = std::vector<Vector>;

struct Link {
  double a, alpha, d;
};

// The position of the chain's end, Eqs. 18 and 26.
Vector forward_kinematics(const std::vector<Link>& links, const Vector& theta);

struct Result {
  Vector theta;
  double error;
};

// Algorithm 2 of Slim et al. 2023.
Result ik_bat(const std::vector<Link>& links, const Vector& target, const Vector& theta_s, const Vector& lower,
              const Vector& upper, int bats, int iterations, std::mt19937_64& generator);

}  // namespace ikbench::microbenchmarks::textbook
