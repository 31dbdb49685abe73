// What is computed in lanes for an arm: the position errors of many candidates, or their errors of a pose. One function
// of each for each instruction set, compiled from kernels.cpp; their bits are the same.
#pragma once

#include <stddef.h>

namespace ikbench::numerics {
enum class InstructionSet;
}

namespace ikbench::robots {

// What a link's joint does.
enum class Joint : unsigned char {
  turns,   // the link and all after it, about z
  slides,  // the same along z, by metres instead of radians
  // It turns this link alone, about y: a linkage such as a parallelogram holds what comes after it in its direction.
  coupled,
};

// A link as the way from the tip to the base meets it; plain data, because kernels know nothing else.
struct KernelLink {
  enum Twist { none, quarter, minus_quarter, general };
  Twist twist;
  bool turns;  // false where the point lies on the joint's axis whatever the other angles are
  Joint joint;
  double cosine, sine;  // of the twist
  double a, d, offset;  // as in DhLink
};

constexpr int most_joints = 64;

struct KernelChain {
  const KernelLink* links;
  int joints;
  double tip[3];
  bool all_turn = true;
};

// Two axes of a frame, each as long as a radian weighs [m].
struct KernelAxes {
  double x[3], y[3];
};

// A pose to reach, in the frame of the first link, and the tool's axes in that of the last.
struct KernelPose {
  double target[3];
  KernelAxes target_axes, tool_axes;
};

struct Kernels {
  // Distance to the target of `count` candidates; joint j of candidate i is q[j * row + i]. Not a finite number where
  // an angle is infinite, NaN or 2^51 quarter turns or more.
  void (*position_errors)(const KernelChain& chain, const double* target, const double* q, ptrdiff_t row,
                          ptrdiff_t count, double* errors);
  // The same for poses: the root mean square of the distances of the tool's point and the ends of its two axes.
  void (*pose_errors)(const KernelChain& chain, const KernelPose& goal, const double* q, ptrdiff_t row, ptrdiff_t count,
                      double* errors);
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

}  // namespace ikbench::robots
