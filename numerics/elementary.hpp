// Sine, cosine and logarithm in lanes, made of + - * / and fused multiply-add only: the same bits on every processor
// and from every compiler. For kernel units only, like lanes.hpp.
#pragma once

#include "numerics/lanes.hpp"

namespace ikbench::numerics {
namespace {

// Adding this to a number below 2^51 leaves the nearest integer in the lowest bits.
constexpr double to_integer = 0x1.8p52;

struct SinCosLanes {
  Reals sine, cosine;
};

// Returns sine and cosine for |r| <= pi/4, within 1 ulp. The coefficients are those of fdlibm's kernels (Sun
// Microsystems 1993).
IKBENCH_LANES SinCosLanes sin_cos_of_eighth(Reals r) {
  const Reals z = r * r;
  Reals s = fused(z, all(1.58969099521155010221e-10), all(-2.50507602534068634195e-08));
  s = fused(z, s, all(2.75573137070700676789e-06));
  s = fused(z, s, all(-1.98412698298579493134e-04));
  s = fused(z, s, all(8.33333333332248946124e-03));
  s = fused(z, s, all(-1.66666666666666324348e-01));
  Reals c = fused(z, all(-1.13596475577881948265e-11), all(2.08757232129817482790e-09));
  c = fused(z, c, all(-2.75573143513906633035e-07));
  c = fused(z, c, all(2.48015872894767294178e-05));
  c = fused(z, c, all(-1.38888888888741095749e-03));
  c = fused(z, c, all(4.16666666666666019037e-02));
  return {fused(r * z, s, r), fused(z, fused(z, c, all(-0.5)), all(1.0))};
}

struct Turned {
  SinCosLanes of;
  Bits turns;  // the bits of to_integer + the number of quarter turns, for `angle_refused`
};

IKBENCH_LANES Reals nearest_turn(Reals angle) {
  return fused(angle, all(0x1.45f306dc9c883p-1), all(to_integer));  // 2/pi
}

// Returns sine and cosine within 1.5 ulp and 1.6e-33 per quarter turn (pi/2 in two parts leaves out so much), for less
// than 2^51 quarter turns. Beyond, the numbers are arbitrary, and `angle_refused` says so.
IKBENCH_LANES Turned sin_cos(Reals angle) {
  const Reals nearest = nearest_turn(angle);
  const Bits quarter = bits(nearest);
  const Reals n = nearest - to_integer;
  Reals r = less_fused(n, all(0x1.921fb54442d18p+0), angle);  // pi/2 in two parts: Cody and Waite 1980
  r = less_fused(n, all(0x1.1a62633145c07p-54), r);
  const SinCosLanes of = sin_cos_of_eighth(r);
  const Bits sine = bits(of.sine), cosine = bits(of.cosine);
  const Bits odd = -(quarter & 1);  // an odd number of quarter turns swaps the two
  return {{reals(((odd & cosine) | (~odd & sine)) ^ ((quarter & 2) << 62)),
           reals(((odd & sine) | (~odd & cosine)) ^ (((quarter + 1) & 2) << 62))},
          quarter};
}

// Combines by `|` the `turns` of one or more angles: all ones if one was 2^51 quarter turns or more, infinite or NaN.
// Only then does the exponent differ from that of to_integer.
IKBENCH_LANES Bits turned_too_far(Bits turns) { return turns ^ 0x4330000000000000u; }
IKBENCH_LANES Bits angle_refused(Bits too_far) { return where_any(too_far, 0xfff0000000000000u); }

// Returns the natural logarithm of a number in [2^-1000, 2^1000], within 2.5 ulp. The coefficients are those of fdlibm
// (Sun Microsystems 1993).
IKBENCH_LANES Reals logarithm(Reals x) {
  constexpr uint64_t root_half = 0x3fe6a09e00000000u, bias = 1024, mantissa = 0x000fffffffffffffu;
  const Bits above = bits(x) + ((bias << 52) - root_half);
  const Reals e = reals((above >> 52) | 0x4330000000000000u) - (0x1p52 + bias);
  const Reals f = reals((above & mantissa) + root_half) - 1.0;  // in [sqrt(1/2), sqrt(2)), less 1
  const Reals s = f / (f + 2.0);                                // log(1 + f) = 2 atanh(s)
  const Reals z = s * s;
  Reals sum = fused(z, all(1.479819860511658591e-01), all(1.531383769920937332e-01));
  sum = fused(z, sum, all(1.818357216161805012e-01));
  sum = fused(z, sum, all(2.222219843214978396e-01));
  sum = fused(z, sum, all(2.857142874366239149e-01));
  sum = fused(z, sum, all(3.999999999940941908e-01));
  sum = fused(z, sum, all(6.666666666666735130e-01));
  return fused(e, all(0x1.62e42fefa39efp-1), fused(s * z, sum, s + s));
}

}  // namespace
}  // namespace ikbench::numerics
