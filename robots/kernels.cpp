// Compiled once for every instruction set; IKBENCH_KERNELS names it. Read lanes.hpp before including anything.
#include "robots/kernels.hpp"

#include "numerics/elementary.hpp"

namespace ikbench::robots {
namespace {

using namespace numerics;

// Chains whose joints all turn, and all other chains.
enum class Kind { all_turn, any };

template <class Goal>
constexpr bool is_pose = false;
template <>
constexpr bool is_pose<KernelPose> = true;

struct Vector {
  Reals x, y, z;
};

IKBENCH_LANES Vector vector(const double* from) { return {all(from[0]), all(from[1]), all(from[2])}; }
IKBENCH_LANES Vector difference(const Vector& a, const double* b) { return {a.x - b[0], a.y - b[1], a.z - b[2]}; }
IKBENCH_LANES Vector sum(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
IKBENCH_LANES Reals squared(const Vector& v) { return fused(v.x, v.x, fused(v.y, v.y, v.z * v.z)); }

IKBENCH_LANES void twist(Vector& v, const KernelLink& link) {
  const Reals y_before = v.y;
  if (link.twist == KernelLink::quarter) {
    v.y = -v.z;
    v.z = y_before;
  } else if (link.twist == KernelLink::minus_quarter) {
    v.y = v.z;
    v.z = -y_before;
  } else if (link.twist != KernelLink::none) {
    if (link.twist == KernelLink::leaning) {
      const Reals x_before = v.x;
      v.x = fused(all(link.lean_cosine), v.x, all(link.lean_sine) * v.z);
      v.z = fused_less(all(link.lean_cosine), v.z, all(link.lean_sine) * x_before);
    }
    v.y = fused_less(all(link.cosine), v.y, all(link.sine) * v.z);
    v.z = fused(all(link.sine), y_before, all(link.cosine) * v.z);
  }
}

IKBENCH_LANES void turn(Vector& v, const SinCosLanes& of) {
  const Reals x_before = v.x;
  v.x = fused_less(of.cosine, v.x, of.sine * v.y);
  v.y = fused(of.sine, x_before, of.cosine * v.y);
}

// Moves a point by the sum over coupled links in a row, and empties the sum.
IKBENCH_LANES void end_run(Vector& at, Reals& run_x, Reals& run_z) {
  at.x = run_x + at.x;
  at.z = run_z + at.z;
  run_x = run_z = all(0);
}

template <Kind kind, class Goal>
IKBENCH_LANES Reals squared_error(const Goal& goal, const Vector& at, [[maybe_unused]] const Vector& along_x,
                                  [[maybe_unused]] const Vector& along_y) {
  const Vector off = difference(at, goal.target);
  if constexpr (is_pose<Goal>) {
    const Vector off_x = sum(off, difference(along_x, goal.target_axes.x)),
                 off_y = sum(off, difference(along_y, goal.target_axes.y));
    return (squared(off) + squared(off_x) + squared(off_y)) * (1.0 / 3);
  } else if constexpr (kind == Kind::any) {
    // Without fused multiply-add, since the Dobot's solves in older stores have these bits.
    return off.x * off.x + off.y * off.y + off.z * off.z;
  } else {
    return squared(off);  // Eq. 1
  }
}

// Returns the error of the candidates in the lanes, of which `load(j)` gives joint j.
template <Kind kind, class Goal, class Load>
IKBENCH_LANES Reals distance(const KernelChain& chain, const Goal& goal, Load load) {
  // Carries one point from the tip to the base: a plane rotation per joint instead of a matrix product. For a pose, two
  // axes go with it.
  Vector at = vector(chain.tip);
  [[maybe_unused]] Vector along_x{}, along_y{};
  if constexpr (is_pose<Goal>) {
    along_x = vector(goal.tool_axes.x);
    along_y = vector(goal.tool_axes.y);
  }
  Bits too_far{};
  [[maybe_unused]] Reals run_x = all(0), run_z = all(0);  // sum over coupled links in a row
#pragma GCC unroll 1
  for (int j = chain.joints - 1; j >= 0; --j) {
    const KernelLink& link = chain.links[j];
    if constexpr (kind == Kind::any) {
      if (link.joint != Joint::coupled || link.twist != KernelLink::none) end_run(at, run_x, run_z);
    }
    twist(at, link);
    if constexpr (is_pose<Goal>) {
      twist(along_x, link);
      twist(along_y, link);
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
    if (link.a != 0) at.x = at.x + link.a;
    if (link.d != 0) at.z = at.z + link.d;
    Reals angle = link.offset != 0 ? load(j) + link.offset : load(j);
    if constexpr (kind == Kind::any) {
      if (link.joint == Joint::slides) {
        at.z = at.z + load(j);
        angle = all(link.offset);
      }
    }
    if (!is_pose<Goal> && !link.turns) {
      too_far |= turned_too_far(bits(nearest_turn(angle)));  // moves nothing, but is refused like any other
      continue;
    }
    const auto [of, turns] = sin_cos(angle);
    too_far |= turned_too_far(turns);
    turn(at, of);
    if constexpr (is_pose<Goal>) {
      turn(along_x, of);
      turn(along_y, of);
    }
  }
  if constexpr (kind == Kind::any) end_run(at, run_x, run_z);
  const Reals square = squared_error<kind>(goal, at, along_x, along_y);
  return reals(bits(root(square)) | angle_refused(too_far));  // all ones are NaN
}

template <Kind kind, class Goal>
IKBENCH_LANES void errors_of(const KernelChain& chain, const Goal& goal, const KernelCandidates& candidates,
                             double* errors) {
  const double* const q = candidates.q;
  const ptrdiff_t row = candidates.row;
  for_lanes(candidates.count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const auto joint = [&](int j) IKBENCH_INLINE { return some.load(q + j * row + i); };
    some.store(errors + i, distance<kind>(chain, goal, joint));
  });
}

template <class Goal>
void errors(const KernelChain& chain, const Goal& goal, const KernelCandidates& candidates, double* out) {
  if (chain.all_turn) return errors_of<Kind::all_turn>(chain, goal, candidates, out);
  errors_of<Kind::any>(chain, goal, candidates, out);
}

}  // namespace

namespace IKBENCH_KERNELS {
Kernels kernels() { return {&errors<KernelPoint>, &errors<KernelPose>}; }
}  // namespace IKBENCH_KERNELS

}  // namespace ikbench::robots
