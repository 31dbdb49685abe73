// What solvers compute in lanes: the blocks of a random stream as uniform and as normal numbers, and equations that
// many share, on one joint's row of candidates. One set of functions for each instruction set, compiled from
// kernels.cpp; their bits are the same.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace ikbench {

enum class InstructionSet;

constexpr int random_lanes = 8;

// The four words of each lane's xoshiro256++, lane beside lane.
struct RandomState {
  uint64_t words[4][random_lanes];
};

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

struct SolverKernels {
  // Each fills `count` numbers and takes whole blocks of eight: what is left of the last is dropped.
  void (*uniforms)(RandomState& state, double* out, ptrdiff_t count);           // [0, 1), 52 bits
  void (*normals)(RandomState& state, double* out, ptrdiff_t count);            // from two blocks sixteen
  void (*truncated_normals)(RandomState& state, double* out, ptrdiff_t count);  // standard normal within [-1, 1]

  void (*fly)(const Flight& flight);  // v_next = v + (x - pole) frequency, x_next = x + v_next
  void (*swarm)(const Swarm& swarm);
  void (*scatter)(double centre, double step, const double* draws, double* q, ptrdiff_t count);  // centre + step draws
  void (*clamp)(double lower, double upper, double* q, ptrdiff_t count);
};

namespace portable {
SolverKernels solver_kernels();
}
namespace x86_64_v3 {
SolverKernels solver_kernels();
}
namespace x86_64_v4 {
SolverKernels solver_kernels();
}

// Of a set that this machine runs.
SolverKernels solver_kernels(InstructionSet set);
// Of the set in use, looked up once.
const SolverKernels& solver_kernels();

}  // namespace ikbench
