// The iiwa 14's flange position in closed form, as one would write it for this one arm: the C library's sin and cos, no
// loop, no table.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace ikbench::microbenchmarks {

// Rz1 Ry2 (d3 z + Rz3 Ry(-4) (d5 z + d7 Rz5 Ry6 z)) + d1 z. The flange does not depend on the last joint.
inline Eigen::Vector3d iiwa_flange(const double* q) {
  constexpr double d1 = 0.36, d3 = 0.42, d5 = 0.4, d7 = 0.126;
  const double h = d7 * std::sin(q[5]);
  const double ax = h * std::cos(q[4]), ay = h * std::sin(q[4]), az = d7 * std::cos(q[5]) + d5;
  const double s4 = std::sin(q[3]), c4 = std::cos(q[3]);
  const double vx = c4 * ax - s4 * az, vz = s4 * ax + c4 * az + d3;
  const double s3 = std::sin(q[2]), c3 = std::cos(q[2]);
  const double ux = c3 * vx - s3 * ay, uy = s3 * vx + c3 * ay;
  const double s2 = std::sin(q[1]), c2 = std::cos(q[1]);
  const double wx = c2 * ux + s2 * vz;
  const double s1 = std::sin(q[0]), c1 = std::cos(q[0]);
  return {c1 * wx - s1 * uy, s1 * wx + c1 * uy, c2 * vz - s2 * ux + d1};
}

}  // namespace ikbench::microbenchmarks
