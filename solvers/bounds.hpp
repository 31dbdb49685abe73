// Joint limits as solvers treat them: first candidates are inside, and an option of the solver decides about later
// ones.
#pragma once

#include <cmath>
#include <numbers>

#include "robots/robot.hpp"
#include "solvers/kernels.hpp"
#include "solvers/options.hpp"
#include "solvers/solver.hpp"

namespace ikbench::solvers {

// The treatment of joints outside their limits.
enum class Bounds {
  initial,  // only the first candidates are inside
  clamp,    // a joint outside is set to its limit
  free,     // a joint outside is turned back by whole turns if possible; a candidate that stays outside is no answer
  resample  // a joint outside is drawn again: the solver does that, by draw_outside_again
};

// Lists the option `bounds` of a solver that follows slopes.
inline void list_bounds_of_search(OptionList& list, Bounds& bounds) {
  list.choice(
      "bounds", bounds, {{"initial", Bounds::initial}, {"clamp", Bounds::clamp}, {"free", Bounds::free}},
      "joint limits apply to the initial candidate only, or all are clamped to them, or the search leaves them, "
      "and only candidates that are inside, by whole turns perhaps, count");
}

// Lists the option `bounds` of a solver that draws candidates.
inline void list_bounds(OptionList& list, Bounds& bounds) {
  list.choice("bounds", bounds, {{"initial", Bounds::initial}, {"clamp", Bounds::clamp}},
              "joint limits apply to the initial candidates only, or all candidates are clamped to them");
}

// Returns the nearest angle inside the limits that differs from q by whole turns; q if there is none. An angle that
// rounding puts beside a limit becomes the limit.
inline double turned_inside(double q, double lower, double upper) {
  constexpr double turn = 2 * std::numbers::pi, rounding = 1e-9;
  double turned = q;
  if (q < lower) turned += turn * std::ceil((lower - q) / turn);
  if (q > upper) turned -= turn * std::ceil((q - upper) / turn);
  if (turned < lower && turned >= lower - rounding) turned = lower;
  if (turned > upper && turned <= upper + rounding) turned = upper;
  return turned >= lower && turned <= upper ? turned : q;
}

// The range from which a joint is drawn: its limits, or for a continuous joint half a turn on both sides of the start.
struct DrawnFrom {
  DrawnFrom(const Problem& problem, Eigen::Index j) : lower(problem.lower[j]), upper(problem.upper[j]) {
    if (!robots::is_endless(lower, upper)) return;
    lower = problem.start[j] - robots::half_turn;
    upper = problem.start[j] + robots::half_turn;
  }
  double lower, upper;
};

// Returns finite limits, for a library or a program that needs them: a continuous joint gets a whole turn on both sides
// of the start.
inline robots::JointLimits finite_limits(const Problem& problem) {
  return robots::JointLimits{problem.lower, problem.upper}.around(problem.start, robots::whole_turn);
}

// Returns true if a candidate counts as an answer.
inline bool counts(Bounds bounds, const Problem& problem, const robots::Configuration& q) {
  return bounds != Bounds::free ||
         ((q.array() >= problem.lower.array()).all() && (q.array() <= problem.upper.array()).all());
}

// Returns true if a search with Bounds::free, which made this step to q, will end outside. Where steps shrink, all
// further ones together are no longer than the last one or two. So a joint that is outside by four steps does not come
// back.
inline bool ends_outside(const Problem& problem, const robots::Configuration& q, const robots::Configuration& step) {
  const double near = 4 * step.cwiseAbs().maxCoeff();
  return (q.array() > problem.upper.array() + near || q.array() < problem.lower.array() - near).any();
}

// Draws candidates uniformly between the limits.
inline void draw_within_limits(const Problem& problem, numerics::Random& random, robots::Candidates& out) {
  random.uniforms(out);
  for (Eigen::Index j = 0; j < out.rows(); ++j) {
    double* const q = &out(j, 0);
    const DrawnFrom from(problem, j);
    kernels().scatter(from.lower, from.upper - from.lower, q, q, out.cols());
  }
}

// Replaces joints that are outside by those of `fresh`, which are drawn within the limits.
template <class Some>
void draw_outside_again(const Problem& problem, const robots::Candidates& fresh, Eigen::Index first, Some&& q) {
  for (Eigen::Index j = 0; j < q.rows(); ++j) {
    auto row = q.row(j).array();
    row =
        (row >= problem.lower[j] && row <= problem.upper[j]).select(row, fresh.row(j).segment(first, q.cols()).array());
  }
}

// Draws one configuration (a vector, or a column), joint after joint.
template <class Some>
void draw_one_within_limits(const Problem& problem, numerics::Random& random, Some&& q) {
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const DrawnFrom from(problem, j);
    q[j] = random.uniform(from.lower, from.upper);
  }
}

// Brings candidates (a vector, or columns of Candidates) back inside, if `bounds` says so.
template <class Some>
void keep_inside(Bounds bounds, const Problem& problem, Some&& q) {
  if (bounds == Bounds::initial || bounds == Bounds::resample) return;
  for (Eigen::Index j = 0; j < q.rows(); ++j) {
    if (bounds == Bounds::free) {  // makes another candidate if the joint is prismatic, which is as good as any
      q(j, 0) = turned_inside(q(j, 0), problem.lower[j], problem.upper[j]);
    } else if (q.cols() == 1) {
      q(j, 0) = std::clamp(q(j, 0), problem.lower[j], problem.upper[j]);
    } else {
      kernels().clamp(problem.lower[j], problem.upper[j], &q.coeffRef(j, 0), q.cols());
    }
  }
}

}  // namespace ikbench::solvers
