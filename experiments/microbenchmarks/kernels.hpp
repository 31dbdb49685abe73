// The limit of forward kinematics: a kernel for one arm, with all its lengths and twists in the code.
#pragma once

#include <stddef.h>

namespace ikbench::numerics {
enum class InstructionSet;
}

namespace ikbench::microbenchmarks {

struct Kernels {
  // Distances of the iiwa 14's flange to the target; joint j of candidate i is q[j * row + i].
  void (*iiwa_errors)(const double* target, const double* q, ptrdiff_t row, ptrdiff_t count, double* errors);
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

// The kernels of a set that this machine runs.
Kernels kernels(numerics::InstructionSet set);
// The kernels of the set in use, looked up once.
const Kernels& kernels();

}  // namespace ikbench::microbenchmarks
