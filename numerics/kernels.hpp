// What is computed in lanes for everybody: sines and cosines of many angles, the blocks of a random stream as uniform
// and as normal numbers. One set of functions for each instruction set, compiled from kernels.cpp; their bits are the
// same.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace ikbench::numerics {

enum class InstructionSet;

constexpr int random_lanes = 8;

// The four words of each lane's xoshiro256++, lane beside lane.
struct RandomState {
  uint64_t words[4][random_lanes];
};

struct Kernels {
  // NaN for an angle that is infinite, NaN or 2^51 quarter turns or more.
  void (*sines_and_cosines)(const double* angles, ptrdiff_t count, double* sines, double* cosines);
  // Each fills `count` numbers and takes whole blocks of eight: what is left of the last is dropped.
  void (*uniforms)(RandomState& state, double* out, ptrdiff_t count);           // [0, 1), 52 bits
  void (*normals)(RandomState& state, double* out, ptrdiff_t count);            // from two blocks sixteen
  void (*truncated_normals)(RandomState& state, double* out, ptrdiff_t count);  // standard normal within [-1, 1]
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
Kernels kernels(InstructionSet set);
// Of the set in use, looked up once.
const Kernels& kernels();

}  // namespace ikbench::numerics
