// Numbers in lanes. `Reals` has as many doubles as the unit's instruction set works on at once; `Bits` are their bit
// patterns. The operators + - * / & | ^ ~ << >> work lane by lane, also where `Reals` is a plain double.
//
// For kernel units only (numerics/, robots/ and solvers/kernels.cpp), which one program contains once per instruction
// set. All names here have internal linkage and none is of std::; otherwise the linker might keep an inline function
// with instructions that an older processor lacks.
#pragma once

#include <stddef.h>
#include <stdint.h>
#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#define IKBENCH_INLINE __attribute__((always_inline))
#define IKBENCH_LANES static inline IKBENCH_INLINE

namespace ikbench::numerics {
namespace {

#if defined(__AVX512F__)

constexpr int width = 8;
typedef double Reals __attribute__((vector_size(64)));
typedef uint64_t Bits __attribute__((vector_size(64)));
IKBENCH_LANES Reals all(double x) { return _mm512_set1_pd(x); }
IKBENCH_LANES Reals fused(Reals a, Reals b, Reals c) { return _mm512_fmadd_pd(a, b, c); }        // a b + c
IKBENCH_LANES Reals fused_less(Reals a, Reals b, Reals c) { return _mm512_fmsub_pd(a, b, c); }   // a b - c
IKBENCH_LANES Reals less_fused(Reals a, Reals b, Reals c) { return _mm512_fnmadd_pd(a, b, c); }  // c - a b
IKBENCH_LANES Reals root(Reals x) { return _mm512_maskz_sqrt_pd(0xff, x); }
IKBENCH_LANES Reals larger(Reals a, Reals b) { return _mm512_maskz_max_pd(0xff, a, b); }   // b if one is NaN
IKBENCH_LANES Reals smaller(Reals a, Reals b) { return _mm512_maskz_min_pd(0xff, a, b); }  // b if one is NaN
IKBENCH_LANES Bits where_any(Bits x, uint64_t of) { return (Bits)((x & of) != 0); }
IKBENCH_LANES Bits where_less(Reals a, Reals b) { return (Bits)(a < b); }
IKBENCH_LANES __mmask8 first(ptrdiff_t count) { return (__mmask8)((1u << count) - 1); }
IKBENCH_LANES Reals load_first(ptrdiff_t count, const double* from) {
  return _mm512_maskz_loadu_pd(first(count), from);
}
IKBENCH_LANES void store_first(ptrdiff_t count, double* to, Reals x) { _mm512_mask_storeu_pd(to, first(count), x); }

#elif defined(__FMA__) && defined(__AVX2__)

constexpr int width = 4;
typedef double Reals __attribute__((vector_size(32)));
typedef uint64_t Bits __attribute__((vector_size(32)));
IKBENCH_LANES Reals all(double x) { return _mm256_set1_pd(x); }
IKBENCH_LANES Reals fused(Reals a, Reals b, Reals c) { return _mm256_fmadd_pd(a, b, c); }
IKBENCH_LANES Reals fused_less(Reals a, Reals b, Reals c) { return _mm256_fmsub_pd(a, b, c); }
IKBENCH_LANES Reals less_fused(Reals a, Reals b, Reals c) { return _mm256_fnmadd_pd(a, b, c); }
IKBENCH_LANES Reals root(Reals x) { return _mm256_sqrt_pd(x); }
IKBENCH_LANES Reals larger(Reals a, Reals b) { return _mm256_max_pd(a, b); }
IKBENCH_LANES Reals smaller(Reals a, Reals b) { return _mm256_min_pd(a, b); }
IKBENCH_LANES Bits where_any(Bits x, uint64_t of) { return (Bits)((x & of) != 0); }
IKBENCH_LANES Bits where_less(Reals a, Reals b) { return (Bits)(a < b); }
IKBENCH_LANES __m256i first(ptrdiff_t count) {
  return _mm256_cmpgt_epi64(_mm256_set1_epi64x(count), _mm256_setr_epi64x(0, 1, 2, 3));
}
IKBENCH_LANES Reals load_first(ptrdiff_t count, const double* from) { return _mm256_maskload_pd(from, first(count)); }
IKBENCH_LANES void store_first(ptrdiff_t count, double* to, Reals x) { _mm256_maskstore_pd(to, first(count), x); }

#elif defined(__aarch64__)

constexpr int width = 2;
typedef double Reals __attribute__((vector_size(16)));
typedef uint64_t Bits __attribute__((vector_size(16)));
IKBENCH_LANES Reals all(double x) { return vdupq_n_f64(x); }
IKBENCH_LANES Reals fused(Reals a, Reals b, Reals c) { return vfmaq_f64(c, a, b); }
IKBENCH_LANES Reals fused_less(Reals a, Reals b, Reals c) { return vfmaq_f64(-c, a, b); }
IKBENCH_LANES Reals less_fused(Reals a, Reals b, Reals c) { return vfmsq_f64(c, a, b); }
IKBENCH_LANES Reals root(Reals x) { return vsqrtq_f64(x); }
IKBENCH_LANES Reals larger(Reals a, Reals b) { return vbslq_f64(vcgtq_f64(a, b), a, b); }
IKBENCH_LANES Reals smaller(Reals a, Reals b) { return vbslq_f64(vcltq_f64(a, b), a, b); }
IKBENCH_LANES Bits where_any(Bits x, uint64_t of) { return (Bits)((x & of) != 0); }
IKBENCH_LANES Bits where_less(Reals a, Reals b) { return (Bits)(a < b); }
IKBENCH_LANES Reals load_first(ptrdiff_t, const double* from) { return Reals{*from, 0}; }
IKBENCH_LANES void store_first(ptrdiff_t, double* to, Reals x) { *to = x[0]; }

#else

constexpr int width = 1;
typedef double Reals;
typedef uint64_t Bits;
IKBENCH_LANES Reals all(double x) { return x; }
IKBENCH_LANES Reals fused(Reals a, Reals b, Reals c) { return __builtin_fma(a, b, c); }
IKBENCH_LANES Reals fused_less(Reals a, Reals b, Reals c) { return __builtin_fma(a, b, -c); }
IKBENCH_LANES Reals less_fused(Reals a, Reals b, Reals c) { return __builtin_fma(-a, b, c); }
IKBENCH_LANES Reals root(Reals x) { return __builtin_sqrt(x); }
IKBENCH_LANES Reals larger(Reals a, Reals b) { return a > b ? a : b; }
IKBENCH_LANES Reals smaller(Reals a, Reals b) { return a < b ? a : b; }
IKBENCH_LANES Bits where_any(Bits x, uint64_t of) { return (x & of) != 0 ? ~uint64_t{0} : 0; }
IKBENCH_LANES Bits where_less(Reals a, Reals b) { return a < b ? ~uint64_t{0} : 0; }
IKBENCH_LANES Reals load_first(ptrdiff_t, const double* from) { return *from; }
IKBENCH_LANES void store_first(ptrdiff_t, double* to, Reals x) { *to = x; }

#endif

// In all branches: `where_any` is all ones in the lanes in which x has one of these bits, else all zeros; `where_less`
// likewise for a < b. `load_first` and `store_first` touch only `count` numbers, 1 to `width`; the other lanes are 0.

IKBENCH_LANES Bits bits(Reals x) { return __builtin_bit_cast(Bits, x); }
IKBENCH_LANES Reals reals(Bits x) { return __builtin_bit_cast(Reals, x); }
IKBENCH_LANES Reals chosen(Bits where, Reals a, Reals b) { return reals((where & bits(a)) | (~where & bits(b))); }

template <class Lanes, class Number>
IKBENCH_LANES Lanes load(const Number* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
template <class Number, class Lanes>
IKBENCH_LANES void store(Number* to, Lanes lanes) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

// Calls body(first, some) for groups of lanes that cover `count` numbers; `some` loads and stores the group's numbers.
struct AllLanes {
  IKBENCH_INLINE Reals load(const double* from) const { return ::ikbench::numerics::load<Reals>(from); }
  IKBENCH_INLINE void store(double* to, Reals x) const { ::ikbench::numerics::store(to, x); }
};
struct FirstLanes {
  ptrdiff_t count;
  IKBENCH_INLINE Reals load(const double* from) const { return load_first(count, from); }
  IKBENCH_INLINE void store(double* to, Reals x) const { store_first(count, to, x); }
};
template <class Body>
IKBENCH_LANES void for_lanes(ptrdiff_t count, Body body) {
  ptrdiff_t i = 0;
#pragma GCC unroll 1
  for (; i + width <= count; i += width) body(i, AllLanes{});
  if (i < count) body(i, FirstLanes{count - i});
}

}  // namespace
}  // namespace ikbench::numerics
