// The joint limits as solvers treat them: first candidates are inside, and options decide about later ones.
#pragma once

#include <cmath>
#include <numbers>

#include "robots/robot.hpp"
#include "solvers/kernels.hpp"
#include "solvers/options.hpp"
#include "solvers/solver.hpp"

namespace ikbench::solvers {

enum class Bounds {
  initial,  // only the first candidates are inside
  clamp,    // a joint outside is set to its limit
  free,     // it is turned back by whole turns, else stays; where a joint is outside, the candidate does not count
  resample  // it is drawn again: the solver does that, by draw_outside_again
};

// Of a search by slopes.
inline void list_bounds_of_search(OptionList& list, Bounds& bounds) {
  list.choice(
      "bounds", bounds, {{"initial", Bounds::initial}, {"clamp", Bounds::clamp}, {"free", Bounds::free}},
      "joint limits apply to the initial candidate only, or all are clamped to them, or the search leaves them, "
      "and only candidates that are inside, by whole turns perhaps, count");
}

inline void list_bounds(OptionList& list, Bounds& bounds) {
  list.choice("bounds", bounds, {{"initial", Bounds::initial}, {"clamp", Bounds::clamp}},
              "joint limits apply to the initial candidates only, or all candidates are clamped to them");
}

// Turns an angle outside the limits back inside by whole turns, to the nearest such angle; leaves it if there is none.
// An angle that rounding puts beside a limit becomes the limit.
inline double turned_inside(double q, double lower, double upper) {
  constexpr double turn = 2 * std::numbers::pi, rounding = 1e-9;
  double turned = q;
  if (q < lower) turned += turn * std::ceil((lower - q) / turn);
  if (q > upper) turned -= turn * std::ceil((q - upper) / turn);
  if (turned < lower && turned >= lower - rounding) turned = lower;
  if (turned > upper && turned <= upper + rounding) turned = upper;
  return turned >= lower && turned <= upper ? turned : q;
}

// The range to draw a joint from: its limits, or half a turn on both sides of the start if it turns without end.
struct DrawnFrom {
  DrawnFrom(const Problem& problem, Eigen::Index j) : lower(problem.lower[j]), upper(problem.upper[j]) {
    if (!robots::is_endless(lower, upper)) return;
    lower = problem.start[j] - robots::half_turn;
    upper = problem.start[j] + robots::half_turn;
  }
  double lower, upper;
};

// Finite limits, for a library or a program that needs them: a joint that turns without end gets a whole turn on both
// sides of the start.
inline robots::JointLimits finite_limits(const Problem& problem) {
  return robots::JointLimits{problem.lower, problem.upper}.around(problem.start, robots::whole_turn);
}

// Whether a candidate counts as an answer.
inline bool counts(Bounds bounds, const Problem& problem, const robots::Configuration& q) {
  return bounds != Bounds::free ||
         ((q.array() >= problem.lower.array()).all() && (q.array() <= problem.upper.array()).all());
}

// Whether a search that made this step to q, and is free, will end outside: where its steps shrink, what follows is no
// more than the last one or two, so a joint that is outside by four does not come back.
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

// Draws joints that are outside again: they become those of `fresh`, drawn within the limits.
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
    if (bounds == Bounds::free) {  // of a joint that slides it makes another candidate, no worse than any
      q(j, 0) = turned_inside(q(j, 0), problem.lower[j], problem.upper[j]);
    } else if (q.cols() == 1) {
      q(j, 0) = std::clamp(q(j, 0), problem.lower[j], problem.upper[j]);
    } else {
      kernels().clamp(problem.lower[j], problem.upper[j], &q.coeffRef(j, 0), q.cols());
    }
  }
}

}  // namespace ikbench::solvers
