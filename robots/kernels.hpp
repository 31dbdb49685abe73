// What is computed in lanes for an arm: positions of many candidates, sines and cosines of many angles. One set of
// functions for each instruction set, compiled from kernels.cpp; their bits are the same.
#pragma once

#include <stddef.h>

namespace ikbench {

enum class InstructionSet;

// A link as the way from the tip to the base meets it; plain data, because kernels know nothing else.
struct KernelLink {
  enum Twist { none, quarter, minus_quarter, general };
  Twist twist;
  bool turns;           // false where the point lies on the joint's axis whatever the other angles are
  double cosine, sine;  // of the twist
  double a, d, offset;  // as in DhLink
};

constexpr int most_joints = 64;

struct KernelChain {
  const KernelLink* links;
  int joints;
  double tip[3];
};

struct RobotKernels {
  // Distance to the target of `count` candidates; joint j of candidate i is q[j * row + i]. Not a finite number where
  // an angle is infinite, NaN or 2^51 quarter turns or more.
  void (*position_errors)(const KernelChain& chain, const double* target, const double* q, ptrdiff_t row,
                          ptrdiff_t count, double* errors);
  // NaN for such angles.
  void (*sines_and_cosines)(const double* angles, ptrdiff_t count, double* sines, double* cosines);
};

namespace portable {
RobotKernels robot_kernels();
}
namespace x86_64_v3 {
RobotKernels robot_kernels();
}
namespace x86_64_v4 {
RobotKernels robot_kernels();
}

// Of a set that this machine runs.
RobotKernels robot_kernels(InstructionSet set);
// Of the set in use, looked up once.
const RobotKernels& robot_kernels();

}  // namespace ikbench
