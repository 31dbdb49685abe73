// Decides when an answer is near enough for a solve to end.
#pragma once

#include <cmath>

#include "solvers/solver.hpp"

namespace ikbench::solvers {

class Tolerance {
 public:
  // `tolerance` [m] of the position, 0: none; `angle_tolerance` [rad] of a pose or an axis.
  Tolerance(double tolerance, double angle_tolerance, const Objective& objective)
      : tolerance_(tolerance),
        angle_tolerance_(angle_tolerance),
        objective_(objective),
        // The tool's own point is off by its position error, the two others by up to weight times chord more; the
        // squares of the three chords of a rotation have the sum 8 sin^2(angle / 2) <= 2 angle^2, and so have twice
        // that of an axis.
        largest_(objective.goal().has_direction()
                     ? tolerance + objective.goal().rotation_weight * angle_tolerance * std::sqrt(2.0 / 3)
                     : tolerance) {}

  // Checks each best pose at most once, and only if its error allows that it is near enough.
  bool is_reached(const Best& best) {
    if (!(tolerance_ > 0) || !(best.error <= largest_)) return false;
    if (!objective_.goal().has_direction()) return true;
    if (best.error == seen_) return false;
    seen_ = best.error;
    const Deviation left = objective_.deviation(best.q);
    return left.position <= tolerance_ && left.angle <= angle_tolerance_;
  }

 private:
  double tolerance_, angle_tolerance_;
  const Objective& objective_;
  double largest_;    // the largest error [m] of a pose within both tolerances
  double seen_ = -1;  // the error of the last best that was checked
};

}  // namespace ikbench::solvers
