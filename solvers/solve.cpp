#include "solvers/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "numerics/instruction_set.hpp"
#include "solvers/kernels.hpp"

namespace ikbench::solvers {

using namespace numerics;

IKBENCH_DEFINE_KERNELS

namespace {

class Tolerance {
 public:
  Tolerance(const StopRule& stop, const Objective& objective)
      : stop_(stop),
        objective_(objective),
        // Of three points, the tool's own is off by its position error, and the others further by weight times chord;
        // the squares of the three chords of a rotation have the sum 8 sin^2(angle / 2) <= 2 angle^2.
        largest_(objective.goal().is_pose()
                     ? stop.tolerance + objective.goal().rotation_weight * stop.angle_tolerance * std::sqrt(2.0 / 3)
                     : stop.tolerance) {}

  // A pose is looked at only where its error allows that it is near enough, and only once.
  bool is_reached(const Best& best) {
    if (!(stop_.tolerance > 0) || !(best.error <= largest_)) return false;
    if (!objective_.goal().is_pose()) return true;
    if (best.error == seen_) return false;
    seen_ = best.error;
    const Deviation left = objective_.deviation(best.q);
    return left.position <= stop_.tolerance && left.angle <= stop_.angle_tolerance;
  }

 private:
  const StopRule& stop_;
  const Objective& objective_;
  double largest_;    // error [m] that a pose within both tolerances can have
  double seen_ = -1;  // the error of the best that was looked at
};

}  // namespace

Solution solve(Solver& solver, const Problem& problem, Objective& objective, Random& random, const StopRule& stop,
               Trace trace) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point started = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - started).count(); };

  Solution solution;
  if (trace == Trace::best_error) solution.trace.reserve(static_cast<std::size_t>(std::min(stop.iterations, 100'000)));
  Tolerance tolerance(stop, objective);
  solver.start(problem, objective, random);
  for (;;) {
    const double error = solver.best().error;
    if (!std::isfinite(error)) {
      solution.stopped = Stopped::not_finite;
    } else if (tolerance.is_reached(solver.best())) {
      solution.stopped = Stopped::tolerance;
    } else if (solver.finished()) {
      solution.stopped = Stopped::finished;
    } else if (solution.iterations >= stop.iterations) {
      solution.stopped = Stopped::iterations;
    } else if (stop.evaluations > 0 && objective.evaluations() >= stop.evaluations) {
      solution.stopped = Stopped::evaluations;
    } else if (stop.seconds > 0 && seconds() >= stop.seconds) {
      solution.stopped = Stopped::time;
    } else {
      solver.step(objective, random);
      ++solution.iterations;
      if (trace == Trace::best_error) solution.trace.push_back(solver.best().error);
      continue;
    }
    break;
  }
  solution.best = solver.best();
  if (!solution.best.q.allFinite()) solution.stopped = Stopped::not_finite;
  const bool is_pose = objective.goal().is_pose() && solution.stopped != Stopped::not_finite;
  solution.position_error = is_pose ? objective.deviation(solution.best.q).position : solution.best.error;
  solution.evaluations = objective.evaluations();
  return solution;
}

}  // namespace ikbench::solvers
