// Functions computed in lanes for an arm: errors of many candidates from a position or a pose. kernels.cpp is compiled
// once per instruction set; all give the same bits.
#pragma once

#include <stddef.h>

#include "numerics/kernels.hpp"

namespace ikbench::robots {

// The motion of a link's joint.
enum class Joint : unsigned char {
  turns,   // revolute or continuous: turns the link and all links after it about z
  slides,  // prismatic: moves them along z, in metres instead of radians
  // Turns only this link about y. A linkage such as a parallelogram keeps the direction of the links after it.
  coupled,
};

// A link on the way from the tip to the base; plain data, as kernels need.
struct KernelLink {
  enum Twist { none, quarter, minus_quarter, general, leaning };  // leaning: general, and then about y
  Twist twist;
  bool turns;  // false if the point lies on the joint's axis whatever the other angles
  Joint joint;
  double cosine, sine;                    // of the twist
  double a, d, offset;                    // as in DhLink
  double lean_cosine = 1, lean_sine = 0;  // of beta, where the twist is leaning
};

constexpr int max_joints = 64;

// A chain as kernels take it.
struct KernelChain {
  const KernelLink* links;
  int joints;
  double tip[3];
  bool all_turn = true;
};

// Two axes of a frame, whose length is the weight of a radian [m].
struct KernelAxes {
  double x[3], y[3];
};

// The goal of a solve: a point in the frame of the first link, or a pose, with the tool's axes in the frame of the last
// link.
struct KernelPoint {
  const double* target;
};
struct KernelPose {
  double target[3];
  KernelAxes target_axes, tool_axes;
};

// `count` candidates as rows of joints: joint j of candidate i is q[j * row + i].
struct KernelCandidates {
  const double* q;
  ptrdiff_t row, count;
};

// Writes the distance [m] of each candidate from the goal. For a pose this is the root mean square of three distances:
// those of the tool's point and of the ends of the tool's two axes. An error is not finite if an angle is infinite, NaN
// or 2^51 quarter turns or more.
template <class Goal>
using KernelErrors = void (*)(const KernelChain& chain, const Goal& goal, const KernelCandidates& candidates,
                              double* errors);
struct Kernels {
  KernelErrors<KernelPoint> position_errors;
  KernelErrors<KernelPose> pose_errors;
};

IKBENCH_DECLARE_KERNELS

}  // namespace ikbench::robots
