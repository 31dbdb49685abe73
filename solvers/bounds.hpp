// The joint limits as solvers treat them: first candidates inside, and what becomes of one that leaves them.
#pragma once

#include <cmath>
#include <numbers>

#include "robots/robot.hpp"
#include "solvers/kernels.hpp"
#include "solvers/options.hpp"
#include "solvers/solver.hpp"

namespace ikbench::solvers {

enum class Bounds {
  initial,  // only the first candidates are inside; later ones go where they like
  clamp,    // a joint outside is set to its limit
};

inline void list_bounds(OptionList& list, Bounds& bounds) {
  list.choice("bounds", bounds, {{"initial", Bounds::initial}, {"clamp", Bounds::clamp}},
              "joint limits apply to the initial candidates only, or all candidates are clamped to them");
}

// An angle outside the limits by whole turns back inside, to the nearest that is; as it is where there is none. What
// rounding puts beside a limit is on it.
inline double turned_inside(double q, double lower, double upper) {
  constexpr double turn = 2 * std::numbers::pi, rounding = 1e-9;
  double turned = q;
  if (q < lower) turned += turn * std::ceil((lower - q) / turn);
  if (q > upper) turned -= turn * std::ceil((q - upper) / turn);
  if (turned < lower && turned >= lower - rounding) turned = lower;
  if (turned > upper && turned <= upper + rounding) turned = upper;
  return turned >= lower && turned <= upper ? turned : q;
}

// What a joint is drawn from: its limits, or where it turns without end half a turn each way of the start.
struct DrawnFrom {
  DrawnFrom(const Problem& problem, Eigen::Index j) : lower(problem.lower[j]), upper(problem.upper[j]) {
    if (!robots::is_endless(lower, upper)) return;
    lower = problem.start[j] - robots::half_turn;
    upper = problem.start[j] + robots::half_turn;
  }
  double lower, upper;
};

// Limits that are finite, for a library or a program that needs such: where a joint turns without end, a whole turn
// each way of the start.
inline robots::JointLimits finite_limits(const Problem& problem) {
  return robots::JointLimits{problem.lower, problem.upper}.around(problem.start, robots::whole_turn);
}

// Uniform between the limits.
inline void draw_within_limits(const Problem& problem, numerics::Random& random, robots::Candidates& out) {
  random.uniforms(out);
  for (Eigen::Index j = 0; j < out.rows(); ++j) {
    double* const q = &out(j, 0);
    const DrawnFrom from(problem, j);
    kernels().scatter(from.lower, from.upper - from.lower, q, q, out.cols());
  }
}

// The same of one configuration (a vector, or a column), joint after joint.
template <class Some>
void draw_one_within_limits(const Problem& problem, numerics::Random& random, Some&& q) {
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const DrawnFrom from(problem, j);
    q[j] = random.uniform(from.lower, from.upper);
  }
}

// Candidates (a vector, or columns of Candidates) back inside, where the reading says so.
template <class Some>
void keep_inside(Bounds bounds, const Problem& problem, Some&& q) {
  if (bounds != Bounds::clamp) return;
  for (Eigen::Index j = 0; j < q.rows(); ++j) {
    if (q.cols() == 1) {
      q(j, 0) = std::clamp(q(j, 0), problem.lower[j], problem.upper[j]);
    } else {
      kernels().clamp(problem.lower[j], problem.upper[j], &q.coeffRef(j, 0), q.cols());
    }
  }
}

}  // namespace ikbench::solvers
