// Converts the record's orientation_error, ||R - Rd|| / ||Rd||, to an angle: for two rotations ||R - Rd|| is sqrt(8)
// sin(angle / 2), and ||Rd|| is sqrt(3).
#pragma once

#include <cmath>

#include "numerics/units.hpp"

namespace ikbench::results {

// NaN stays NaN.
inline double orientation_angle_deg(double orientation_error) {
  const double sine = orientation_error * std::sqrt(3.0 / 8);
  return 2 * std::asin(sine > 1 ? 1.0 : sine) / numerics::degree;
}

}  // namespace ikbench::results
