// What is drawn in lanes: the blocks of a random stream, as uniform and as normal numbers. One set of functions for
// each instruction set, compiled from random_kernels.cpp; their bits are the same.
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

struct RandomKernels {
  // Each fills `count` numbers and takes whole blocks of eight: what is left of the last is dropped.
  void (*uniforms)(RandomState& state, double* out, ptrdiff_t count);           // [0, 1), 52 bits
  void (*normals)(RandomState& state, double* out, ptrdiff_t count);            // from two blocks sixteen
  void (*truncated_normals)(RandomState& state, double* out, ptrdiff_t count);  // standard normal within [-1, 1]
};

namespace portable {
RandomKernels random_kernels();
}
namespace x86_64_v3 {
RandomKernels random_kernels();
}
namespace x86_64_v4 {
RandomKernels random_kernels();
}

// Of a set that this machine runs.
RandomKernels random_kernels(InstructionSet set);

}  // namespace ikbench
