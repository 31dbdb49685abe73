// Equations that many solvers share, on one joint's row of candidates, in lanes. One set of functions for each
// instruction set, compiled from row_kernels.cpp; their bits are the same.
#pragma once

#include <stddef.h>

namespace ikbench {

enum class InstructionSet;

// A joint of `count` candidates that a velocity moves; a next place may be the one before.
struct Flight {
  double pole;  // what the velocity grows away from
  const double* frequency;
  const double *x, *v;
  double *x_next, *v_next;
  ptrdiff_t count;
};

struct RowKernels {
  void (*fly)(const Flight& flight);  // v_next = v + (x - pole) frequency, x_next = x + v_next
  void (*scatter)(double centre, double step, const double* draws, double* q, ptrdiff_t count);  // centre + step draws
};

namespace portable {
RowKernels row_kernels();
}
namespace x86_64_v3 {
RowKernels row_kernels();
}
namespace x86_64_v4 {
RowKernels row_kernels();
}

// Of a set that this machine runs.
RowKernels row_kernels(InstructionSet set);
// Of the set in use, looked up once.
const RowKernels& row_kernels();

}  // namespace ikbench
