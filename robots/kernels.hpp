// What is computed in lanes for an arm: the position errors of many candidates. One function for each instruction set,
// compiled from kernels.cpp; their bits are the same.
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

struct Kernels {
  // Distance to the target of `count` candidates; joint j of candidate i is q[j * row + i]. Not a finite number where
  // an angle is infinite, NaN or 2^51 quarter turns or more.
  void (*position_errors)(const KernelChain& chain, const double* target, const double* q, ptrdiff_t row,
                          ptrdiff_t count, double* errors);
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
