// Compiled once for every instruction set, with IKBENCH_KERNELS naming it; read lanes.hpp before including anything.
#include "robots/kernels.hpp"

#include "numerics/elementary.hpp"

namespace ikbench::robots {
namespace {

using namespace numerics;

// The chains whose joints all turn, and those with others among them.
enum class Kind { all_turn, any };

// `load` gives joint j of the candidates in the lanes.
template <Kind kind, class Load>
IKBENCH_LANES Reals distance(const KernelChain& chain, const double* target, Load load) {
  // One point, carried from the tip to the base: a plane rotation a joint instead of a matrix product.
  Reals x = all(chain.tip[0]), y = all(chain.tip[1]), z = all(chain.tip[2]);
  Bits too_far{};
  [[maybe_unused]] Reals run_x = all(0), run_z = all(0);  // of coupled links in a row, whose sum is added to the point
#pragma GCC unroll 1
  for (int j = chain.joints - 1; j >= 0; --j) {
    const KernelLink& link = chain.links[j];
    if constexpr (kind == Kind::any) {
      if (link.joint != Joint::coupled || link.twist != KernelLink::none) {
        x = run_x + x;
        z = run_z + z;
        run_x = run_z = all(0);
      }
    }
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
    if constexpr (kind == Kind::any) {
      if (link.joint == Joint::coupled) {
        const auto [of, turns] = sin_cos(link.offset != 0 ? load(j) + link.offset : load(j));
        too_far |= turned_too_far(turns);
        run_x = fused(all(link.a), of.cosine, link.d * of.sine) + run_x;
        run_z = fused_less(all(link.d), of.cosine, link.a * of.sine) + run_z;
        continue;
      }
    }
    if (link.a != 0) x = x + link.a;
    if (link.d != 0) z = z + link.d;
    Reals angle = link.offset != 0 ? load(j) + link.offset : load(j);
    if constexpr (kind == Kind::any) {
      if (link.joint == Joint::slides) {
        z = z + load(j);
        angle = all(link.offset);
      }
    }
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
  if constexpr (kind == Kind::any) {
    x = run_x + x;
    z = run_z + z;
  }
  const Reals dx = x - target[0], dy = y - target[1], dz = z - target[2];
  // Eq. 1; without fused multiply-add as it was for the Dobot, whose solves in older stores have these bits.
  const Reals squared = kind == Kind::any ? dx * dx + dy * dy + dz * dz : fused(dx, dx, fused(dy, dy, dz * dz));
  return reals(bits(root(squared)) | angle_refused(too_far));  // all ones are NaN
}

template <Kind kind>
IKBENCH_LANES void position_errors_of(const KernelChain& chain, const double* target, const double* q, ptrdiff_t row,
                                      ptrdiff_t count, double* errors) {
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const auto joint = [&](int j) IKBENCH_INLINE { return some.load(q + j * row + i); };
    some.store(errors + i, distance<kind>(chain, target, joint));
  });
}

void position_errors(const KernelChain& chain, const double* target, const double* q, ptrdiff_t row, ptrdiff_t count,
                     double* errors) {
  if (chain.all_turn) {
    position_errors_of<Kind::all_turn>(chain, target, q, row, count, errors);
  } else {
    position_errors_of<Kind::any>(chain, target, q, row, count, errors);
  }
}

}  // namespace

namespace IKBENCH_KERNELS {
Kernels kernels() { return {&position_errors}; }
}  // namespace IKBENCH_KERNELS

}  // namespace ikbench::robots
