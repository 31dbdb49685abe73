// The places of the joints of a study's arm, for drawing it.
#pragma once

#include <array>
#include <vector>

#include "analysis/inference/study_facts.hpp"

namespace ikbench::figures {

using Point = std::array<double, 3>;  // x, y, z [m]

// The corners of the arm from the base to the tool. None where the definition has no arm, or the angles are not those
// of its joints.
std::vector<Point> arm_points(const inference::StudyFacts& facts, const std::vector<double>& angles_rad);

}  // namespace ikbench::figures
