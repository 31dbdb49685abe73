// Compiled once for every instruction set; IKBENCH_KERNELS names it. Read lanes.hpp before including anything.
#include "tests/benchmarks/kernels.hpp"

#include "numerics/elementary.hpp"

namespace ikbench::benchmarks {
namespace {

using namespace numerics;

// Rz1 Ry2 (d3 z + Rz3 Ry(-4) (d5 z + d7 Rz5 Ry6 z)) + d1 z, from the flange to the base, with the sines and cosines of
// all our kernels. The flange does not depend on the last joint. Unlike ours, it refuses no angle.
void iiwa_errors(const double* target, const double* q, ptrdiff_t row, ptrdiff_t count, double* errors) {
  const Reals d1 = all(0.36), d3 = all(0.42), d5 = all(0.4), d7 = all(0.126);
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const auto turned = [&](int joint) IKBENCH_INLINE { return sin_cos(some.load(q + (joint - 1) * row + i)).of; };
    const auto [s6, c6] = turned(6);
    const auto [s5, c5] = turned(5);
    const Reals h = d7 * s6, ax = h * c5, ay = h * s5, az = fused(d7, c6, d5);
    const auto [s4, c4] = turned(4);
    const Reals vx = fused_less(c4, ax, s4 * az), vz = fused(s4, ax, fused(c4, az, d3));
    const auto [s3, c3] = turned(3);
    const Reals ux = fused_less(c3, vx, s3 * ay), uy = fused(s3, vx, c3 * ay);
    const auto [s2, c2] = turned(2);
    const Reals wx = fused(c2, ux, s2 * vz), z = fused(c2, vz, less_fused(s2, ux, d1));
    const auto [s1, c1] = turned(1);
    const Reals x = fused_less(c1, wx, s1 * uy), y = fused(s1, wx, c1 * uy);
    const Reals dx = x - target[0], dy = y - target[1], dz = z - target[2];
    some.store(errors + i, root(fused(dx, dx, fused(dy, dy, dz * dz))));
  });
}

}  // namespace

namespace IKBENCH_KERNELS {
Kernels kernels() { return {&iiwa_errors}; }
}  // namespace IKBENCH_KERNELS

}  // namespace ikbench::benchmarks
