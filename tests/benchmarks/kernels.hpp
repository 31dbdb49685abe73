// The limit of forward kinematics: a kernel for one arm, with all its lengths and twists in the code.
#pragma once

#include <stddef.h>

#include "numerics/kernels.hpp"

namespace ikbench::benchmarks {

struct Kernels {
  // Distances of the iiwa 14's flange to the target; joint j of candidate i is q[j * row + i].
  void (*iiwa_errors)(const double* target, const double* q, ptrdiff_t row, ptrdiff_t count, double* errors);
};

IKBENCH_DECLARE_KERNELS

}  // namespace ikbench::benchmarks
