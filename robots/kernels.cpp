// Compiled once for every instruction set, with IKBENCH_KERNELS naming it; read lanes.hpp before including anything.
#include "robots/kernels.hpp"

#include "numerics/elementary.hpp"

namespace ikbench::robots {
namespace {

using namespace numerics;

// `load` gives joint j of the candidates in the lanes.
template <class Load>
IKBENCH_LANES Reals distance(const KernelChain& chain, const double* target, Load load) {
  // One point, carried from the tip to the base: a plane rotation a joint instead of a matrix product.
  Reals x = all(chain.tip[0]), y = all(chain.tip[1]), z = all(chain.tip[2]);
  Bits too_far{};
#pragma GCC unroll 1
  for (int j = chain.joints - 1; j >= 0; --j) {
    const KernelLink& link = chain.links[j];
    const Reals y_before = y;
    if (link.twist == KernelLink::quarter) {
      y = -z;
      z = y_before;
    } else if (link.twist == KernelLink::minus_quarter) {
      y = z;
      z = -y_before;
    } else if (link.twist == KernelLink::general) {
      y = fused_less(all(link.cosine), y, all(link.sine) * z);
      z = fused(all(link.sine), y_before, all(link.cosine) * z);
    }
    if (link.a != 0) x = x + link.a;
    if (link.d != 0) z = z + link.d;
    const Reals angle = link.offset != 0 ? load(j) + link.offset : load(j);
    if (!link.turns) {
      too_far |= turned_too_far(bits(nearest_turn(angle)));  // no way to go, but refused like any other
      continue;
    }
    const auto [of, turns] = sin_cos(angle);
    too_far |= turned_too_far(turns);
    const Reals x_before = x;
    x = fused_less(of.cosine, x, of.sine * y);
    y = fused(of.sine, x_before, of.cosine * y);
  }
  const Reals dx = x - target[0], dy = y - target[1], dz = z - target[2];
  const Reals error = root(fused(dx, dx, fused(dy, dy, dz * dz)));  // Eq. 1
  return reals(bits(error) | angle_refused(too_far));               // all ones are NaN
}

void position_errors(const KernelChain& chain, const double* target, const double* q, ptrdiff_t row, ptrdiff_t count,
                     double* errors) {
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const auto joint = [&](int j) IKBENCH_INLINE { return some.load(q + j * row + i); };
    some.store(errors + i, distance(chain, target, joint));
  });
}

}  // namespace

namespace IKBENCH_KERNELS {
Kernels kernels() { return {&position_errors}; }
}  // namespace IKBENCH_KERNELS

}  // namespace ikbench::robots
