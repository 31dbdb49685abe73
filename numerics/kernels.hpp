// Functions computed in lanes for all other parts: sines and cosines of many angles, and blocks of uniform or normal
// random numbers. kernels.cpp is compiled once per instruction set; all give the same bits.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace ikbench::numerics {

enum class InstructionSet;

// Declares, in a folder's namespace, the table of its kernels for each instruction set that they are compiled for, for
// a set that this machine runs, and for the set in use, looked up once (IKBENCH_DEFINE_KERNELS).
#define IKBENCH_DECLARE_KERNELS                  \
  namespace portable {                           \
  Kernels kernels();                             \
  }                                              \
  namespace x86_64_v3 {                          \
  Kernels kernels();                             \
  }                                              \
  namespace x86_64_v4 {                          \
  Kernels kernels();                             \
  }                                              \
  Kernels kernels(numerics::InstructionSet set); \
  const Kernels& kernels();

constexpr int random_lanes = 8;

// The four words of each lane's xoshiro256++, stored lane beside lane.
struct RandomState {
  uint64_t words[4][random_lanes];
};

// The kernels of one instruction set.
struct Kernels {
  // Writes NaN for an angle that is infinite, NaN or 2^51 quarter turns or more.
  void (*sines_and_cosines)(const double* angles, ptrdiff_t count, double* sines, double* cosines);
  // Each of these three writes `count` numbers, made of whole blocks of eight, and drops the rest of the last block.
  void (*uniforms)(RandomState& state, double* out, ptrdiff_t count);           // [0, 1), 52 bits
  void (*normals)(RandomState& state, double* out, ptrdiff_t count);            // sixteen from two blocks
  void (*truncated_normals)(RandomState& state, double* out, ptrdiff_t count);  // standard normal within [-1, 1]
};

IKBENCH_DECLARE_KERNELS

}  // namespace ikbench::numerics
