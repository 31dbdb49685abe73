// Loaded before everything else (LD_PRELOAD), this makes the processor round upwards, and treat subnormal numbers as 0,
// as libraries do that are compiled with -ffast-math. IKBENCH_ROUNDS says when: "load" is when this is loaded, and the
// name of a function of NLopt is when the program calls it. Nothing here undoes it.
#include <dlfcn.h>
#include <fenv.h>
#include <stdlib.h>
#include <string.h>

#ifdef __x86_64__
#include <xmmintrin.h>
#endif

namespace {

void round_upwards(const char* when) {
  if (getenv("IKBENCH_ROUNDS") == nullptr || strcmp(getenv("IKBENCH_ROUNDS"), when) != 0) return;
  fesetround(FE_UPWARD);
#ifdef __x86_64__
  _mm_setcsr(_mm_getcsr() | 0x8040U);  // subnormal numbers are 0
#endif
}

struct Loaded {
  Loaded() {
    unsetenv("LD_PRELOAD");  // what the program starts keeps its own
    round_upwards("load");
  }
};
const Loaded loaded;

}  // namespace

// The functions are those of NLopt, whose header is not needed: its types are pointers.
extern "C" void* nlopt_create(int algorithm, unsigned dimensions) {
  static const auto next = reinterpret_cast<void* (*)(int, unsigned)>(dlsym(RTLD_NEXT, "nlopt_create"));
  round_upwards("nlopt_create");
  return next(algorithm, dimensions);
}

extern "C" int nlopt_optimize(void* optimizer, double* x, double* least) {
  static const auto next = reinterpret_cast<int (*)(void*, double*, double*)>(dlsym(RTLD_NEXT, "nlopt_optimize"));
  const int result = next(optimizer, x, least);
  round_upwards("nlopt_optimize");
  return result;
}

extern "C" void nlopt_destroy(void* optimizer) {
  static const auto next = reinterpret_cast<void (*)(void*)>(dlsym(RTLD_NEXT, "nlopt_destroy"));
  round_upwards("nlopt_destroy");
  next(optimizer);
}
