// What solvers compute in lanes: equations that many share, on one joint's row of candidates. One set of functions for
// each instruction set, compiled from kernels.cpp; their bits are the same.
#pragma once

#include <stddef.h>

namespace ikbench::numerics {
enum class InstructionSet;
}

namespace ikbench::solvers {

// A joint of `count` candidates that a velocity moves; a next place may be the one before.
struct Flight {
  double pole;  // what the velocity grows away from
  const double* frequency;
  const double *x, *v;
  double *x_next, *v_next;
  ptrdiff_t count;
};

// A joint of `count` particles: v_next = inertia v + cognitive u1 (personal - x) + social u2 (best - x), x_next = x +
// v_next.
struct Swarm {
  double inertia, cognitive, social, best;
  const double *x, *v, *personal, *u1, *u2;
  double *x_next, *v_next;
  ptrdiff_t count;
};

struct Kernels {
  void (*fly)(const Flight& flight);  // v_next = v + (x - pole) frequency, x_next = x + v_next
  void (*swarm)(const Swarm& swarm);
  void (*scatter)(double centre, double step, const double* draws, double* q, ptrdiff_t count);  // centre + step draws
  // q where its chance is below `limit`, else `other`.
  void (*choose)(const double* chance, double limit, const double* other, double* q, ptrdiff_t count);
  void (*clamp)(double lower, double upper, double* q, ptrdiff_t count);
};

namespace portable {
Kernels kernels();
}
namespace x86_64_v3 {
Kernels kernels();
}
namespace x86_64_v4 {
Kernels kernels();
}

// Of a set that this machine runs.
Kernels kernels(numerics::InstructionSet set);
// Of the set in use, looked up once.
const Kernels& kernels();

}  // namespace ikbench::solvers
