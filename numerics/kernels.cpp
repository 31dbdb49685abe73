// Compiled once for every instruction set; IKBENCH_KERNELS names it. Read lanes.hpp before including anything.
#include "numerics/kernels.hpp"

#include "numerics/elementary.hpp"

namespace ikbench::numerics {
namespace {

void sines_and_cosines(const double* angles, ptrdiff_t count, double* sines, double* cosines) {
  for_lanes(count, [&](ptrdiff_t i, auto some) IKBENCH_INLINE {
    const auto [of, turns] = sin_cos(some.load(angles + i));
    const Bits refused = angle_refused(turned_too_far(turns));
    some.store(sines + i, reals(bits(of.sine) | refused));
    some.store(cosines + i, reals(bits(of.cosine) | refused));
  });
}

constexpr int groups = random_lanes / width;  // a block of eight numbers takes as many lanes

// The stream's state in registers during a fill.
struct Stream {
  Bits s0[groups], s1[groups], s2[groups], s3[groups];
};

IKBENCH_LANES Stream opened(const RandomState& state) {
  Stream stream;
  for (int g = 0; g < groups; ++g) {
    stream.s0[g] = load<Bits>(state.words[0] + g * width);
    stream.s1[g] = load<Bits>(state.words[1] + g * width);
    stream.s2[g] = load<Bits>(state.words[2] + g * width);
    stream.s3[g] = load<Bits>(state.words[3] + g * width);
  }
  return stream;
}

IKBENCH_LANES void close(const Stream& stream, RandomState& state) {
  for (int g = 0; g < groups; ++g) {
    store(state.words[0] + g * width, stream.s0[g]);
    store(state.words[1] + g * width, stream.s1[g]);
    store(state.words[2] + g * width, stream.s2[g]);
    store(state.words[3] + g * width, stream.s3[g]);
  }
}

IKBENCH_LANES Bits rotated(Bits x, int left) { return (x << left) | (x >> (64 - left)); }

// xoshiro256++ (Blackman and Vigna 2019): the next numbers of a group of lanes.
IKBENCH_LANES Bits next(Stream& stream, int g) {
  Bits &s0 = stream.s0[g], &s1 = stream.s1[g], &s2 = stream.s2[g], &s3 = stream.s3[g];
  const Bits drawn = rotated(s0 + s3, 23) + s0;
  const Bits t = s1 << 17;
  s2 ^= s0;
  s3 ^= s1;
  s1 ^= s2;
  s0 ^= s3;
  s2 ^= t;
  s3 = rotated(s3, 45);
  return drawn;
}

IKBENCH_LANES Reals from_1_to_2(Bits drawn) { return reals((drawn >> 12) | 0x3ff0000000000000u); }

// Copies the first numbers of a block, if not all fit.
IKBENCH_LANES void copy(const double* block, ptrdiff_t count, double* out) {
  for (ptrdiff_t i = 0; i < count; ++i) out[i] = block[i];
}

// Fills whole blocks; `draw(stream, block)` writes as many numbers as a block has.
template <int block_size, class Draw>
IKBENCH_LANES void fill(RandomState& state, double* out, ptrdiff_t count, Draw draw) {
  Stream stream = opened(state);
#pragma GCC unroll 1
  for (; count >= block_size; count -= block_size, out += block_size) draw(stream, out);
  if (count > 0) {
    double last[block_size];
    draw(stream, last);
    copy(last, count, out);
  }
  close(stream, state);
}

void uniforms(RandomState& state, double* out, ptrdiff_t count) {
  fill<random_lanes>(state, out, count, [](Stream& stream, double* block) IKBENCH_INLINE {
    for (int g = 0; g < groups; ++g) store(block + g * width, from_1_to_2(next(stream, g)) - 1.0);
  });
}

// Box and Muller 1958, from a block u of radii and a block v of angles: sqrt(-2 log(1 - u)) times the cosine and the
// sine of an angle. v is the angle's place in its quadrant; the two lowest bits of the draw, which v does not use, are
// the quadrant.
void normals(RandomState& state, double* out, ptrdiff_t count) {
  constexpr double quarter_turn = 1.57079632679489661923;
  fill<2 * random_lanes>(state, out, count, [](Stream& stream, double* block) IKBENCH_INLINE {
    for (int g = 0; g < groups; ++g) {
      const Reals radius = root(-logarithm(2.0 - from_1_to_2(next(stream, g))));  // over the root of 2
      const Bits drawn = next(stream, g);
      // From the middle of the quadrant: cos(x + pi/4) = (cos x - sin x) / sqrt(2), and the sine with +.
      const SinCosLanes of = sin_cos_of_eighth(quarter_turn * (from_1_to_2(drawn) - 1.5));
      const Bits left = drawn << 63, down = (drawn & 2) << 62;
      store(block + g * width, reals(bits(radius * (of.cosine - of.sine)) ^ left));
      store(block + random_lanes + g * width, reals(bits(radius * (of.cosine + of.sine)) ^ down));
    }
  });
}

// The inverse of the normal distribution function between its values at -1 and 1: algorithm AS 241 (Wichura 1988), its
// central part.
IKBENCH_LANES Reals truncated_normal(Reals share) {  // in [-1/2, 1/2)
  constexpr double within_1 = 0.68268949213708590;   // share of normal numbers within 1: erf(1 / sqrt(2))
  const Reals q = within_1 * share;
  const Reals r = 0.180625 - q * q;
  Reals above = fused(all(2.5090809287301226727e3), r, all(3.3430575583588128105e4));
  above = fused(above, r, all(6.7265770927008700853e4));
  above = fused(above, r, all(4.5921953931549871457e4));
  above = fused(above, r, all(1.3731693765509461125e4));
  above = fused(above, r, all(1.9715909503065514427e3));
  above = fused(above, r, all(1.3314166789178437745e2));
  above = fused(above, r, all(3.3871328727963666080e0));
  Reals below = fused(all(5.2264952788528545610e3), r, all(2.8729085735721942674e4));
  below = fused(below, r, all(3.9307895800092710610e4));
  below = fused(below, r, all(2.1213794301586595867e4));
  below = fused(below, r, all(5.3941960214247511077e3));
  below = fused(below, r, all(6.8718700749205790830e2));
  below = fused(below, r, all(4.2313330701600911252e1));
  below = fused(below, r, all(1.0));
  return q * above / below;
}

void truncated_normals(RandomState& state, double* out, ptrdiff_t count) {
  fill<random_lanes>(state, out, count, [](Stream& stream, double* block) IKBENCH_INLINE {
    for (int g = 0; g < groups; ++g) store(block + g * width, truncated_normal(from_1_to_2(next(stream, g)) - 1.5));
  });
}

}  // namespace

namespace IKBENCH_KERNELS {
Kernels kernels() { return {&sines_and_cosines, &uniforms, &normals, &truncated_normals}; }
}  // namespace IKBENCH_KERNELS

}  // namespace ikbench::numerics
