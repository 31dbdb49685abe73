// The loop that drives every solver, and stops, counts, traces and times all of them alike.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "solvers/solver.hpp"

namespace ikbench::solvers {

using numerics::StopReason;

enum class Trace { none, best_error };

// The result of a solve.
struct Solution {
  Best best;
  std::int64_t iterations = 0;
  std::int64_t evaluations = 0;
  int restarts = 0;
  StopReason stopped = StopReason::iterations;
  double position_error = 0;  // [m] of the best answer; equals its error if positions are searched
  std::vector<double> trace;  // best error [m] after each iteration; only of solve_traced
  // The improvements from evaluation 1, with the error at the start (or of the first candidates, if that is larger), to
  // the last evaluation; only of solve_traced.
  Improvements improved;
};

// The test whether an answer is near enough for a solve to end.
class Tolerance {
 public:
  Tolerance(const StopRule& stop, const Objective& objective)
      : stop_(stop),
        objective_(objective),
        // The tool's own point is off by its position error, the two others by up to weight times chord more; the
        // squares of the three chords of a rotation have the sum 8 sin^2(angle / 2) <= 2 angle^2, and so have twice
        // that of an axis.
        largest_(objective.goal().has_direction()
                     ? stop.tolerance + objective.goal().rotation_weight * stop.angle_tolerance * std::sqrt(2.0 / 3)
                     : stop.tolerance) {}

  // Returns true if the best answer is within the tolerances. Each best pose is checked once at most, and only if its
  // error allows that it is within them.
  bool is_reached(const Best& best) {
    if (!(stop_.tolerance > 0) || !(best.error <= largest_)) return false;
    if (!objective_.goal().has_direction()) return true;
    if (best.error == seen_) return false;
    seen_ = best.error;
    const Deviation left = objective_.deviation(best.q);
    return stop_.is_met(left.position, left.angle);
  }

 private:
  StopRule stop_;
  const Objective& objective_;
  double largest_;    // the largest error [m] of a pose within both tolerances
  double seen_ = -1;  // the error of the last best that was checked
};

// Returns the limit of the rule that is reached, apart from tolerances; nullopt while there is budget.
std::optional<StopReason> spent(const StopRule& stop, std::int64_t iterations, std::int64_t evaluations,
                                std::chrono::steady_clock::time_point started);

// Lets a solver solve one problem, from its start until a rule of `stop` holds or the solver has finished. Stops with
// `not_finite` if the best error or the answer is not finite, or if the answer has not one number per joint; in the
// last case all numbers of the answer are NaN.
Solution solve(Solver& solver, const Problem& problem, Objective& objective, numerics::Random& random,
               const StopRule& stop);
// Solves as `solve` does, with the same numbers, and records `trace` and `improved`.
Solution solve_traced(Solver& solver, const Problem& problem, Objective& objective, numerics::Random& random,
                      const StopRule& stop);

}  // namespace ikbench::solvers
