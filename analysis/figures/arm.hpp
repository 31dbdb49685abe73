// The arm of a study, as the store has it, and where its joints are, so that it can be drawn.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/inference/study_facts.hpp"

namespace ikbench::figures {

using Point = std::array<double, 3>;  // x, y, z [m]

// As robots/chain.hpp has it: standard Denavit-Hartenberg form.
struct ArmLink {
  enum class Joint { turns, slides, coupled } joint;
  double offset_rad, d_m, a_m, alpha_rad;
  // Limits [rad], or [m] where it slides; infinite where it turns without end, not_defined where the store does not
  // say.
  double lower, upper;
};

struct ArmFrame {
  Point position_m, rpy_rad;
};

struct Arm {
  std::vector<ArmLink> links;
  ArmFrame base, tool;
};

// None where the definition has no arm whose every length and angle is known and within 3600.
std::optional<Arm> arm_of(const inference::StudyFacts& facts);

// The corners of the arm from the base to the tool. None where the definition has no arm, or the angles are not those
// of its joints.
std::vector<Point> arm_points(const inference::StudyFacts& facts, const std::vector<double>& angles_rad);

}  // namespace ikbench::figures
